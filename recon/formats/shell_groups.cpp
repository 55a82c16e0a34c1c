#include "recon/formats/shell_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/portable_math.h"
#include "recon/formats/json_values.h"

namespace odontoscope {

std::vector<ShellGroup> shell_groups(const WrittenSurface& solid) {
  if (solid.report.shell_of.size() != solid.surface.triangles.size()) {
    throw InternalError("a surface and its report do not belong together");
  }
  std::vector<ShellGroup> groups;
  for (const Shell::Kind kind : {Shell::Kind::external, Shell::Kind::cavity, Shell::Kind::open}) {
    ShellGroup group{solid.structure + " " + name(kind), solid.structure, kind, 0, 0, {}};
    for (const Shell& shell : solid.report.shells) {
      if (shell.kind != kind) continue;
      ++group.shells;
      group.volume += shell.volume;
    }
    for (std::uint32_t t = 0; t < solid.surface.triangles.size(); ++t) {
      if (solid.report.shells[solid.report.shell_of[t]].kind == kind) group.triangles.push_back(t);
    }
    if (!group.triangles.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

bool is_certified(const WrittenModel& model) {
  return model.certified && std::all_of(model.solids.begin(), model.solids.end(), [](const WrittenSurface& solid) {
           return solid.report.closed_oriented_manifold();
         });
}

std::string certificate_in_words(const WrittenModel& model) {
  if (!is_certified(model)) return "not certified";
  return fmt::format("certified by odontoscope: every surface closed, manifold, oriented outwards{}",
                     model.slices_checked > 0 ? fmt::format("; exact at {} slices", model.slices_checked) : "");
}

const Paint& paint_for(const std::string& structure, Shell::Kind kind) {
  static constexpr Paint enamel{"enamel", {0.90, 0.86, 0.74}, 0.3, 0.22},
      dentine{"dentine", {0.80, 0.62, 0.33}, 0.6, 0.36}, pulp{"pulp", {0.55, 0.06, 0.06}, 0.5},
      other{"other", {0.55, 0.58, 0.62}, 0.6}, tooth{"tooth", {0.87, 0.80, 0.64}, 0.4, 0.36};
  if (kind == Shell::Kind::cavity) return pulp;
  const std::string first = structure.substr(0, structure.find('+'));
  for (const Paint* paint : {&enamel, &dentine, &pulp, &tooth}) {
    if (paint->name == first) return *paint;
  }
  return other;
}

double screen_value(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * portable::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace odontoscope
