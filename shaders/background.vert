// A gradient from top to bottom as a strip of bands, so narrow that within one the encoded colour runs straight.
#include "tone.glsl"

uniform float bands;
uniform vec3 background_top;      // linear
uniform vec3 background_bottom;

noperspective out vec3 encoded_colour;

void main() {
  float part = float(gl_VertexID / 2) / bands;
  encoded_colour = encoded(mix(background_bottom, background_top, part));
  gl_Position = vec4((gl_VertexID & 1) == 0 ? -1.0 : 1.0, 2.0 * part - 1.0, 0.0, 1.0);
}
