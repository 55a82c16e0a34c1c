#include "engine/app/draft.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/shells.h"
#include "recon/core/error.h"
#include "recon/delaunay/reconstruct.h"

namespace odontoscope::app {
namespace {

constexpr std::size_t most_slices = 22, worth_it_from = 44;   // below which the whole is made in little more time
constexpr std::size_t most_points = 64;                       // of a contour

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

}  // namespace

std::optional<LoadedModel> draft_of(const ContourStack& stack, const std::string& title, const Progress& progress) {
  if (stack.slices.size() < worth_it_from) return {};
  const std::size_t step = (stack.slices.size() + most_slices - 1) / most_slices;
  try {
    const Progress quiet{{}, progress.stop};
    const Reconstruction made = reconstruct(thinned(stack, step), {.correspondence = Correspondence::overlap, .between = Between::delaunay}, quiet);
    std::vector<NamedSurface> surfaces;
    LoadedModel draft;
    for (const Solid& solid : made.solids) {
      odontoscope::add_shells(solid.structure, solid.surface, solid.report, surfaces);
      draft.triangles += solid.surface.triangles.size();
    }
    if (surfaces.empty()) return {};
    draft.title = title;
    draft.model = make_model(surfaces);
    draft.scene = usual_scene(draft.model, 1);
    draft.pickable = std::make_shared<const Pickable>(draft.model, quiet);
    draft.certificate = {Certificate::Verdict::look_here, fmt::format("A draft of one slice in {}: the model is still being made", step), {}};
    return draft;
  } catch (const Error&) {   // thinned contours may cross: the model itself will tell what is wrong, if anything is
    return {};
  }
}

}  // namespace odontoscope::app
