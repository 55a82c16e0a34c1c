// A flat rectangle in the room: a panel, a label, a hand's ray. Its corners are counted as a strip of two triangles.
uniform mat4 to_clip;
uniform vec3 corner;       // the upper left one, metres from the eye's own place
uniform vec3 across;       // from there to the upper right one
uniform vec3 down;         // and to the lower left one
uniform vec2 sheet_from;   // what it shows of the sheet, 0 to 1
uniform vec2 sheet_to;

out vec2 at;

void main() {
  vec2 share = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  at = mix(sheet_from, sheet_to, share);
  gl_Position = to_clip * vec4(corner + share.x * across + share.y * down, 1.0);
}
