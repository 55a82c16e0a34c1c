#include "engine/app/tour_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/app/whole_structures.h"
#include "recon/cavity/centre_lines.h"

namespace odontoscope::app {
namespace {

/// The lamp's reach, in local radii: the next bend is lit, what lies far behind it is dark.
constexpr double lamp_reach = 5;
const Colour wall_colour = colour_of(0xd9b48f);

/// "mesiobuccal canal" as one types it.
std::string typed(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
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

Tour tour_of(const Shown& shown, const std::string& wanted, Session& session) {
  const std::vector<WholeStructure> whole = whole_structures(shown.surfaces);
  const std::vector<Cavity> cavities = cavities_in(looked_at(whole));
  if (cavities.empty()) throw UsageError("--tour: there is no void inside", "A pulp must be closed off from the outside, or be a body with \"pulp\" in its name.");
  const CentreLines lines = centre_lines(cavities.front(), {}, session.progress());
  std::string names;
  for (const NamedLine& line : named_lines(lines)) {
    if (typed(wanted) == line.name || typed(wanted) == line.number) return Tour(*line.line);
    names += (names.empty() ? "" : ", ") + (line.name == line.number ? line.number : fmt::format("{} ({})", line.number, line.name));
  }
  throw UsageError(fmt::format("--tour: there is no line \"{}\"", wanted), names.empty() ? "The void has no branches." : "There are " + names + ".");
}

Scene frame_of(const Scene& scene, const Shown& shown, const Tour& tour, double seconds) {
  const TourInstant now = tour.at(seconds);
  Scene frame = scene;
  frame.camera = now.camera;
  frame.section.reset();
  frame.overlays = {};
  frame.background = {Background::Kind::plain, {0, 0, 0}, {0, 0, 0}};
  frame.headlight = Headlight{lamp_reach * now.width};
  frame.back_faces = BackFaces::cull;
  const bool has_cavity = std::any_of(shown.model.parts.begin(), shown.model.parts.end(), [](const ModelPart& part) { return part.cavity; });
  for (Look& look : frame.looks) {
    const auto part = std::find_if(shown.model.parts.begin(), shown.model.parts.end(), [&](const ModelPart& p) { return p.structure == look.structure; });
    if (part == shown.model.parts.end()) continue;
    const bool pulp = typed(look.structure).find("pulp") != std::string::npos;
    look.visible = has_cavity ? part->cavity : pulp;
    look.opacity = 1;
    look.as_body = !has_cavity;
    look.colour = wall_colour;
  }
  return frame;
}

}  // namespace odontoscope::app
