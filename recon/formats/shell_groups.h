#pragma once
// A model as people look at it: one named part for each structure's external surfaces and one for its cavities.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "recon/formats/written_model.h"

namespace odontoscope {

/// The shells of one kind of one structure: "enamel external", "tooth cavity".
struct ShellGroup {
  std::string name, structure;
  Shell::Kind kind = Shell::Kind::open;
  std::size_t shells = 0;
  double volume = 0;                     // mm^3
  std::vector<std::uint32_t> triangles;  // by number, ascending
};

/// In the order external, cavity, open; those that are there. InternalError if the report is not of that surface.
std::vector<ShellGroup> shell_groups(const WrittenSurface& solid);

/// Certified by the engine, and every surface as it now is a closed oriented manifold.
bool is_certified(const WrittenModel& model);
/// "certified by odontoscope: every surface closed, manifold, oriented outwards; exact at 12 slices" or that it is not.
std::string certificate_in_words(const WrittenModel& model);

struct Paint {
  std::string_view name;
  std::array<double, 3> colour;  // linear
  double roughness;
  double see_through = 1;  // its opacity where the pulp within is to be seen
};

/// The colours of an anatomy atlas. A joint structure "tooth+pulp" goes by its first name, a cavity is taken for the
/// pulp's.
const Paint& paint_for(const std::string& structure, Shell::Kind kind);

/// What a screen's encoding (sRGB) writes for a linear value from 0 to 1.
double screen_value(double linear);

}  // namespace odontoscope
