// What eases the eyes in a headset: a fade to the dark, and the edges of sight darkened while one glides.
uniform float dark;        // 1: all of it
uniform float vignette;    // 1: only the middle is left
uniform vec2 low;          // the picture's corner, as tangents from the line of sight
uniform vec2 high;
uniform vec2 corner;       // of the target's viewport
uniform vec2 pixels;

layout(location = 0) out vec4 out_colour;

void main() {
  float off = length(mix(low, high, (gl_FragCoord.xy - corner) / pixels));
  float edge = smoothstep(0.42, 0.80, off);
  out_colour = vec4(0.0, 0.0, 0.0, max(dark, vignette * edge));
}
