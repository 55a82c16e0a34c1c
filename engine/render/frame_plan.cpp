#include "engine/render/frame_plan.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/scene/turned_out.h"

namespace odontoscope {

namespace {

glm::vec4 plane_of(const Section& section, const GpuModel& model) {
  const glm::dvec3 normal = glm::normalize(section.normal);
  const double distance = metres_per_mm * glm::dot(normal, section.point_mm - model.origin_mm);
  return glm::vec4(glm::vec3(normal), static_cast<float>(distance));
}

/// A cap faces the side that was cut away; from the other side it is a back face like any other.
bool cap_faces_eye(const glm::vec4& plane, const FramePlan& plan) {
  const glm::mat4 eye_to_world = glm::inverse(plan.view.world_to_eye);
  if (plan.parallel) return glm::dot(glm::vec3(plane), glm::vec3(eye_to_world[2])) > 0;
  return glm::dot(glm::vec3(plane), glm::vec3(eye_to_world[3])) > plane.w;
}

std::vector<const GpuPart*> surfaces_of(const std::string& solid, const GpuModel& model) {
  std::vector<const GpuPart*> surfaces;
  for (const GpuPart& part : model.parts)
    if (part.solid == solid) surfaces.push_back(&part);
  return surfaces;
}

/// Pixels around the model for the width of lines.
constexpr int margin = 8;

/// Everything if part of the model's box lies behind the eye.
PixelRectangle touched_by(const glm::vec3& box_low, const glm::vec3& box_high, const FramePlan& plan) {
  const glm::ivec2 size(plan.size.width, plan.size.height);
  glm::vec2 low(1), high(-1);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::vec3 place(corner & 1u ? box_high.x : box_low.x, corner & 2u ? box_high.y : box_low.y,
                          corner & 4u ? box_high.z : box_low.z);
    const glm::vec4 clip = plan.view.eye_to_clip * plan.view.world_to_eye * glm::vec4(place, 1);
    if (!(clip.w > 0) || clip.z < -clip.w) return {{0, 0}, size};
    low = glm::min(low, glm::vec2(clip) / clip.w);
    high = glm::max(high, glm::vec2(clip) / clip.w);
  }
  const auto pixel = [&](const glm::vec2& place) {
    return glm::ivec2(glm::floor(0.5f * (glm::clamp(place, -1.0f, 1.0f) + 1.0f) * glm::vec2(size)));
  };
  return {glm::max(pixel(low) - margin * plan.side, glm::ivec2(0)),
          glm::min(pixel(high) + margin * plan.side + 1, size)};
}

constexpr glm::vec4 keeps_everything{0, 0, 0, 1};

void add_overlay(const GpuOverlay& overlay, const GpuModel& model, const Scene& scene, FramePlan& plan) {
  const auto look = [&](const std::string& structure) { return scene.look_of(structure); };
  for (const GpuPart& part : overlay.slab) {
    if (look(part.structure) && !look(part.structure)->visible) continue;
    std::size_t index = 0;
    while (index < model.parts.size() && model.parts[index].structure != part.structure) ++index;
    const Colour colour = look(part.structure) ? look(part.structure)->colour : usual_colour(part.structure, index);
    plan.opaque.push_back({.part = &part, .colour = linear(colour), .wire = true, .whole = true});
  }
  for (const GpuLines& lines : overlay.lines) {
    if (look(lines.structure) && !look(lines.structure)->visible) continue;
    plan.lines.push_back({&lines, lines.kind == LineKind::measure});
  }
}

}  // namespace

FramePlan plan_frame(const GpuModel& model, const Scene& scene, const View& view, PixelSize size, int side,
                     const GpuOverlay* overlay, const GpuValueGrid* values) {
  FramePlan plan;
  plan.view = view;
  plan.size = {side * size.width, side * size.height};
  plan.side = side;
  plan.touched = touched_by(model.low, model.high, plan);
  plan.centre = model.centre;
  plan.radius = model.radius;
  plan.back_faces = scene.back_faces;
  plan.wire = scene.wire;
  plan.wall_depth = scene.wall_depth;
  plan.wall_thickness = scene.wall_thickness;
  plan.data_colours = scene.data_colours;
  plan.parallel = view.eye_to_clip[2][3] == 0;
  plan.occlusion = scene.occlusion;
  if (scene.headlight) {
    // Held beside the eye: from the eye itself it would flatten what it shows.
    const auto reach = static_cast<float>(metres_per_mm * scene.headlight->reach_mm);
    plan.lamp = {0.10f * reach, 0.16f * reach, 0, reach};
  }
  if (scene.section) plan.section = plane_of(*scene.section, model);
  plan.cap_grain = scene.cap.shows != CapLook::Shows::plain;
  if (values && scene.cap.shows == CapLook::Shows::ct) {
    plan.cap_values = values;
    plan.cap_window = scene.cap.window.value_or(values->usual);
  }
  const bool capped = scene.section && cap_faces_eye(plan.section, plan);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const GpuPart& part = model.parts[i];
    const Look* found = scene.look_of(part.structure);
    const Look look = found ? *found : Look{part.structure, usual_colour(part.structure, i)};
    if (!look.visible) continue;
    const DrawnPart drawn{&part, linear(look.colour), look.opacity,
                          turned_out(scene, look, part.structure != part.solid, capped)};
    if (look.opacity >= 1)
      plan.opaque.push_back(drawn);
    else if (look.opacity > 0)
      plan.translucent.push_back(drawn);
    if (capped && part.structure == part.solid)
      plan.capped.push_back({surfaces_of(part.solid, model), drawn.colour, part.box_volume});
    // A volume has values in a cavity, too.
    if (capped && plan.cap_values && part.structure != part.solid && look.as_body)
      plan.capped.push_back({{&part}, drawn.colour, part.box_volume});
  }
  std::stable_sort(plan.capped.begin(), plan.capped.end(),
                   [](const CappedSolid& a, const CappedSolid& b) { return a.box_volume > b.box_volume; });
  if (overlay) add_overlay(*overlay, model, scene, plan);
  return plan;
}

void touch_box(const glm::vec3& low, const glm::vec3& high, FramePlan& plan) {
  const PixelRectangle box = touched_by(low, high, plan);
  plan.touched = {glm::min(plan.touched.low, box.low), glm::max(plan.touched.high, box.high)};
}

void set_section(const Program& program, const FramePlan& plan, bool whole) {
  program.set("section", whole ? keeps_everything : plan.section);
}

void set_view(const Program& program, const FramePlan& plan) {
  program.set("world_to_eye", plan.view.world_to_eye);
  program.set("eye_to_clip", plan.view.eye_to_clip);
  program.set("section", plan.section);
  program.set("parallel", plan.parallel ? 1 : 0);
  program.set("lamp", plan.lamp);
}

}  // namespace odontoscope
