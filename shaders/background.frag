noperspective in vec3 encoded_colour;

layout(location = 0) out vec4 out_colour;

void main() { out_colour = vec4(encoded_colour, 1.0); }
