// Panels and marks, in pixels from the picture's upper left corner.
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 texture_place;
layout(location = 2) in vec4 colour;      // sRGB encoded, as the framebuffer is

uniform vec2 pixels;

out vec2 at;
out vec4 tint;

void main() {
  at = texture_place;
  tint = colour;
  gl_Position = vec4(2.0 * place.x / pixels.x - 1.0, 1.0 - 2.0 * place.y / pixels.y, 0.0, 1.0);
}
