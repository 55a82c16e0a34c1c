// A surface in the colours of numbers: how far it lies from the data's own surface, or how steep they are there (engine/scene/data_colours.h).
uniform int show_data;        // 0: the surface's own colour; 1: distance; 2: slope
uniform float data_reach;     // from here on the last colour
uniform vec3 data_low, data_middle, data_high, data_nowhere;   // linear
const float nowhere = 0.5e9;  // half of no_deviation

vec3 colour_of_data(vec2 data) {
  if (abs(data.x) > nowhere && show_data == 1) return data_nowhere;
  float part = show_data == 1 ? clamp(data.x / data_reach, -1.0, 1.0) : clamp(2.0 * data.y / data_reach - 1.0, -1.0, 1.0);
  return part < 0.0 ? mix(data_middle, data_low, -part) : mix(data_middle, data_high, part);
}
