#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace odontoscope {

bool ValueWindow::sensible() const {
  constexpr double most = 1e30, least_width = 1e-30;
  return std::abs(low) <= most && std::abs(high) <= most && high - low >= least_width &&
         static_cast<float>(low) < static_cast<float>(high);
}

namespace {

/// The outermost tissue is clearest; each further in is denser, and the innermost opaque.
constexpr float outermost_opacity = 0.22f;
constexpr float middle_opacity = 0.36f;

Box box_of(const ModelPart& part) {
  Box box;
  if (part.positions.empty()) return box;
  box.low = box.high = part.positions.front();
  for (const glm::vec3& position : part.positions) {
    box.low = glm::min(box.low, glm::dvec3(position));
    box.high = glm::max(box.high, glm::dvec3(position));
  }
  return box;
}

bool holds(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) && glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

bool hides(const ModelPart& outer, const ModelPart& inner) {
  const auto outer_depth = depth_in_tooth(outer.structure), inner_depth = depth_in_tooth(inner.structure);
  if (outer_depth && inner_depth) return *outer_depth < *inner_depth;
  return holds(box_of(outer), box_of(inner));
}

float usual_opacity(const Model& model, const ModelPart& part) {
  const auto hides_it = [](const ModelPart& outer, const ModelPart& inner) {
    return &outer != &inner && hides(outer, inner);
  };
  const bool hides_some =
      std::any_of(model.parts.begin(), model.parts.end(), [&](const ModelPart& p) { return hides_it(part, p); });
  const bool hidden =
      std::any_of(model.parts.begin(), model.parts.end(), [&](const ModelPart& p) { return hides_it(p, part); });
  if (!hides_some) return 1;
  return hidden ? middle_opacity : outermost_opacity;
}

/// Where a cavity and what fills it end between slices, each ends by its own course: it may stick out a little there.
constexpr double sticks_out = 0.02;  // of the cavity's diagonal

bool filled(const Model& model, const ModelPart& cavity) {
  Box box = box_of(cavity);
  const double reach = sticks_out * glm::length(box.high - box.low);
  box.low -= reach;
  box.high += reach;
  return std::any_of(model.parts.begin(), model.parts.end(), [&](const ModelPart& part) {
    return &part != &cavity && !part.cavity && holds(box, box_of(part));
  });
}

/// The wall of a cavity that something fills belongs to its solid; an empty one is shown as what is missing there.
Look usual_look(const Model& model, const ModelPart& part, std::size_t index) {
  Look look{part.structure, usual_colour(part.structure, index), usual_opacity(model, part)};
  if (!part.cavity) return look;
  look.as_body = !filled(model, part);
  if (look.as_body) return look;
  look.colour = usual_colour(part.solid, index);
  look.opacity = middle_opacity;
  return look;
}

}  // namespace

Look* Scene::look_of(std::string_view structure) {
  const auto found =
      std::find_if(looks.begin(), looks.end(), [&](const Look& look) { return look.structure == structure; });
  return found == looks.end() ? nullptr : &*found;
}

const Look* Scene::look_of(std::string_view structure) const { return const_cast<Scene*>(this)->look_of(structure); }

void make_opaque(Scene& scene) {
  for (Look& look : scene.looks) look.opacity = 1;
  scene.back_faces = BackFaces::cull;
}

Scene usual_scene(const Model& model, double aspect) {
  Scene scene;
  scene.camera = fit(NamedView::three_quarter, model, aspect);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const ModelPart& part = model.parts[i];
    if (scene.look_of(part.structure)) continue;
    scene.looks.push_back(usual_look(model, part, i));
  }
  return scene;
}

void show_as(VolumeLook::Shows shows, Scene& scene) {
  scene.volume.shows = shows;
  if (shows != VolumeLook::Shows::both) return;
  if (scene.volume.projects()) scene.volume.cast = VolumeLook::Cast::shaded;
  for (Look& look : scene.looks)
    if (!look.as_body) look.opacity = std::min(look.opacity, around_volume);
}

}  // namespace odontoscope
