// Nothing is seen there, in every target of a layer.
layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_ambient;
layout(location = 2) out float out_depth;

void main() {
  out_light = out_ambient = vec4(0.0);
  out_depth = 0.0;
}
