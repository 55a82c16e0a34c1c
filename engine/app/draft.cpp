#include "engine/app/draft.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/shells.h"
#include "recon/core/error.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/formats/read_mesh.h"

namespace odontoscope::app {
namespace {

constexpr std::size_t most_slices = 22, worth_it_from = 44;  // below which the whole is made in little more time
constexpr std::size_t most_points = 64;                      // of a contour

/// Every so many-th, and the last.
ContourStack thinned(const ContourStack& stack, std::size_t step) {
  ContourStack few;
  few.source = stack.source;
  for (std::size_t i = 0; i < stack.slices.size(); ++i)
    if (i % step == 0 || i + 1 == stack.slices.size()) few.slices.push_back(stack.slices[i]);
  for (Slice& slice : few.slices)
    for (Contour& contour : slice.contours) {
      const std::size_t every = (contour.points.size() + most_points - 1) / most_points;
      if (every < 2) continue;
      std::vector<Point2> kept;
      for (std::size_t i = 0; i < contour.points.size(); i += every) kept.push_back(contour.points[i]);
      contour.points = std::move(kept);
    }
  return few;
}

LoadedModel shown_as(const std::vector<NamedSurface>& surfaces, const std::string& title, std::string words,
                     const Progress& progress) {
  LoadedModel draft;
  draft.title = title;
  draft.model = make_model(surfaces);
  draft.scene = usual_scene(draft.model, 1);
  draft.pickable = std::make_shared<const Pickable>(draft.model, progress);
  draft.certificate = {Certificate::Verdict::look_here, std::move(words), {}};
  for (const NamedSurface& named : surfaces) draft.triangles += named.surface.triangles.size();
  return draft;
}

}  // namespace

std::optional<LoadedModel> draft_of(const ContourStack& stack, const std::string& title, const Progress& progress) {
  if (stack.slices.size() < worth_it_from) return {};
  const std::size_t step = (stack.slices.size() + most_slices - 1) / most_slices;
  try {
    const Progress quiet{{}, progress.stop};
    const Reconstruction made =
        reconstruct(thinned(stack, step),
                    {.correspondence = Correspondence::overlap, .between = Between::delaunay, .links = {}}, quiet);
    std::vector<NamedSurface> surfaces;
    for (const Solid& solid : made.solids)
      odontoscope::add_shells(solid.structure, solid.surface, solid.report, surfaces);
    if (surfaces.empty()) return {};
    return shown_as(surfaces, title, fmt::format("A draft of one slice in {}: the model is still being made", step),
                    quiet);
  } catch (const Error&) {  // thinned contours may cross: the model itself will tell what is wrong, if anything is
    return {};
  }
}

LoadedModel draft_of_sample(const std::string& title, const Progress& progress) {
  constexpr std::string_view outside = " external", cavity = " cavity";
  std::vector<NamedSurface> surfaces;
  for (NamedMesh& mesh : parse_glb(draft_files().front().bytes, std::string(draft_files().front().name))) {
    std::string name = mesh.name;
    const bool hollow = name.ends_with(cavity);
    if (hollow)
      surfaces.push_back({name, std::move(mesh.surface), name.substr(0, name.size() - cavity.size()), true});
    else {
      if (name.ends_with(outside)) name.resize(name.size() - outside.size());
      surfaces.push_back({name, std::move(mesh.surface), name});
    }
  }
  return shown_as(surfaces, title, "A draft with few triangles: the model is still being made", {{}, progress.stop});
}

}  // namespace odontoscope::app
