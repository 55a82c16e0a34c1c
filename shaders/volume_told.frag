// What a ray would see, interpolated between four that were cast where those are alike; others are left to be cast.
uniform sampler2D coarse;    // what was seen by rays `coarser` times as far apart
uniform sampler2D alike;     // 1: those between such a ray, its right neighbour and those above are told by them
uniform int coarser;

layout(location = 0) out vec4 out_colour;

void main() {
  ivec2 fragment = ivec2(gl_FragCoord.xy), cell = fragment / coarser, within = fragment - coarser * cell, last = textureSize(coarse, 0) - 1;
  bool seen = within == ivec2(0);
  if (!seen && (texelFetch(alike, cell, 0).r < 0.5 || any(greaterThanEqual(cell, last)))) discard;
  vec4 own = texelFetch(coarse, cell, 0), right = texelFetch(coarse, min(cell + ivec2(1, 0), last), 0);
  vec4 above = texelFetch(coarse, min(cell + ivec2(0, 1), last), 0), across = texelFetch(coarse, min(cell + 1, last), 0);
  vec2 part = vec2(within) / float(coarser);
  out_colour = mix(mix(own, right, part.x), mix(above, across, part.x), part.y);
}
