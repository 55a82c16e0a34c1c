// The length of a ray inside a solid is the sum of the distances of the faces that it leaves by, less those that it enters by: added up by the graphics card, in any order.
// Where a section cuts, faces on its far side do not count.
in vec3 eye_place;
in vec3 place;
uniform vec4 section;        // keeps what has dot(xyz, place) <= w
uniform float attenuation;   // for each unit of length
uniform float middle;        // a distance about which little is lost
uniform int parallel;

layout(location = 0) out vec4 out_swallowed;   // and what is left over of attenuations where some faces do not count

void main() {
  if (dot(section.xyz, place) > section.w) discard;
  float left = gl_FrontFacing ? -attenuation : attenuation;
  out_swallowed = vec4(left * ((parallel != 0 ? -eye_place.z : length(eye_place)) - middle), left, 0.0, 1.0);
}
