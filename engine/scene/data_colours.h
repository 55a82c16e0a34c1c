#pragma once
// Surfaces in the colours of numbers: how far they lie from the data, and how steep these are there.

#include <array>
#include <string_view>

#include "assets/theme.h"
#include "engine/scene/colour.h"
#include "recon/core/named.h"

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
  const auto& stops = of == DataColours::Of::distance ? assets::theme::data::distance : assets::theme::data::slope;
  return {colour_of(stops[0]), colour_of(stops[1]), colour_of(stops[2])};
}
/// Of what lies nowhere near the data's surface.
inline constexpr Colour nowhere_near = colour_of(assets::theme::data::nowhere_near);

inline constexpr NameTable<DataColours::Of, 2> surface_colourings{
    {{"distance", DataColours::Of::distance}, {"slope", DataColours::Of::slope}}};
inline const char* name(DataColours::Of of) { return word_of(surface_colourings, of); }
/// Throws UsageError with the list of names.
inline DataColours::Of data_colours_named(std::string_view name) {
  return value_named(surface_colourings, name, "colouring of surfaces called");
}

}  // namespace odontoscope
