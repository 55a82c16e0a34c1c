#pragma once
// Surfaces in the colours of numbers: how far they lie from the data, and how steep these are there.

#include <array>
#include <string_view>

#include "engine/scene/colour.h"

namespace odontoscope {

/// Distance: blue where the data reach beyond the model, white where both agree, red where the model reaches beyond the
/// data. Slope: from dark blue (none) to yellow. Colours that every kind of colour vision tells apart, and greys too
/// for the slope. Light falls on them as on any other, so that dark may be shadow: the legend's colours are those of
/// full light.
struct DataColours {
  enum class Of { distance, slope };
  Of of = Of::distance;
  double reach = 1;  // mm, or values a millimetre: from here on the last colour; above 0
  friend bool operator==(const DataColours&, const DataColours&) = default;
};

/// The colours of -reach, 0, reach; of 0, half of reach, reach. Between them linear light runs straight.
constexpr std::array<Colour, 3> stops_of(DataColours::Of of) {
  if (of == DataColours::Of::distance) return {colour_of(0x2166ac), colour_of(0xf7f7f7), colour_of(0xb2182b)};
  return {colour_of(0x00204c), colour_of(0x7c7b78), colour_of(0xffe945)};
}
/// Of what lies nowhere near the data's surface.
inline constexpr Colour nowhere_near = colour_of(0x3a3a3a);

const char* name(DataColours::Of of);
/// "distance", "slope". Throws UsageError for anything else.
DataColours::Of data_colours_named(std::string_view name);

}  // namespace odontoscope
