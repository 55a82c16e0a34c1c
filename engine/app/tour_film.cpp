#include "engine/app/tour_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/app/whole_structures.h"
#include "engine/navigate/seen_within.h"
#include "recon/cavity/centre_lines.h"
#include "recon/core/lower_case.h"

namespace odontoscope::app {
namespace {

/// The lamp's reach, in local radii: the next bend is lit, what lies far behind it is dark.
constexpr double lamp_reach = 5;

/// "mesiobuccal canal" as one types it.
std::string typed(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return lower_case(std::move(name));
}

/// The model's part that walls the void in.
VoidWall wall_of(const Cavity& cavity, const Model& model) {
  const bool open = !cavity.mouths.empty();   // then the outer surface leads inside
  for (const ModelPart& part : model.parts)
    if (part.cavity != open && part.solid == cavity.structure) return {part.structure, false};
  return {cavity.structure, cavity.body};
}

struct NamedLine {
  std::string name, number;   // "mesiobuccal-canal", "canal-1"
  const CentreLine* line;
};

std::vector<NamedLine> named_lines(const CentreLines& lines) {
  std::vector<NamedLine> named;
  const auto add = [&](const std::vector<CentreLine>& some, const char* kind) {
    for (std::size_t i = 0; i < some.size(); ++i) named.push_back({typed(some[i].name), fmt::format("{}-{}", kind, i + 1), &some[i]});
  };
  add(lines.canals, "canal");
  add(lines.horns, "horn");
  add(lines.others, "branch");
  add(lines.loops, "loop");
  return named;
}

}  // namespace

Film film_of(const Shown& shown, const std::string& wanted, Session& session) {
  const std::vector<NamedMesh> whole = whole_structures(shown.surfaces);
  const std::vector<Cavity> cavities = cavities_in(looked_at(whole));
  if (cavities.empty()) throw UsageError("--tour: there is no void inside", "A pulp must be closed off from the outside, open along z and deep for its mouth, or be a body with \"pulp\" in its name.");
  const CentreLines lines = centre_lines(cavities.front(), {}, session.progress());
  std::string names;
  for (const NamedLine& line : named_lines(lines)) {
    if (typed(wanted) == line.name || typed(wanted) == line.number) return {Tour(*line.line), wall_of(cavities.front(), shown.model)};
    names += (names.empty() ? "" : ", ") + (line.name == line.number ? line.number : fmt::format("{} ({})", line.number, line.name));
  }
  throw UsageError(fmt::format("--tour: there is no line \"{}\"", wanted), names.empty() ? "The void has no branches." : "There are " + names + ".");
}

Scene frame_of(const Scene& scene, const Shown& shown, const Film& film, double seconds) {
  const TourInstant now = film.tour.at(seconds);
  Scene frame = seen_within(scene, shown.model, film.wall, lamp_reach * now.width);
  frame.camera = now.camera;
  frame.back_faces = BackFaces::cull;
  return frame;
}

}  // namespace odontoscope::app
