#pragma once
// Names beside the tooth seen from outside, each with a line to a place on its structure. A click tells what the
// structure is.

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ui/interface.h"
#include "engine/viewer/viewer_state.h"

namespace odontoscope {

/// Where a structure may be pointed at from outside.
struct NamedPlaces {
  std::string structure;
  std::vector<glm::dvec3> places, everywhere;  // mm: near one height, and all over it
  glm::dvec3 low{0}, high{0};
};

struct StructureNames {
  std::vector<NamedPlaces> places;
  std::optional<std::size_t> told;  // the one that was clicked
};

/// Where structures may be pointed at, chosen once a model. Cavities have none, unless nothing fills them.
std::vector<NamedPlaces> named_places(const Model& model, const Scene& usual);

/// A name as it is drawn: words in a box, and a line to its place.
struct DrawnName {
  std::size_t which = 0;  // of StructureNames::places
  glm::dvec2 place{0};    // pixels
  Area box;
};
/// Of what is visible and lies in the picture; with a section, at the cut. What something opaque hides has no name.
std::vector<DrawnName> drawn_names(const StructureNames& names, const ViewerState& state, const ViewPane& pane,
                                   const Interface& interface, float scale);
void draw_names(const StructureNames& names, const ViewerState& state, const ViewPane& pane, const Interface& interface,
                float scale);
/// Whose name is at this pixel.
std::optional<std::size_t> name_hit(const StructureNames& names, const ViewerState& state, const ViewPane& pane,
                                    const Interface& interface, float scale, double x, double y);

/// What a structure is, in two sentences, by its name; empty: not known. Terms after Terminologia Anatomica (FIPAT,
/// second edition, 2019), with dentine for dentin.
std::string_view told_of(std::string_view structure);

}  // namespace odontoscope
