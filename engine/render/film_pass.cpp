#include "engine/render/film_pass.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "engine/scene/model.h"

namespace odontoscope {

namespace {

constexpr auto metres_to_mm = static_cast<float>(1 / metres_per_mm);
constexpr float nothing_left = 1e-3f;  // 1/mm

/// The section's plane as the eye has it; the eye does not scale.
glm::vec4 in_eye_space(const glm::vec4& plane, const glm::mat4& world_to_eye) {
  const glm::vec3 normal = glm::mat3(world_to_eye) * glm::vec3(plane);
  return {normal, plane.w + glm::dot(normal, glm::vec3(world_to_eye[3]))};
}

/// A cavity's wall is one of its solid's surfaces: whether it is looked at matters to no ray.
bool counts(const GpuPart& part, const Scene& scene) {
  const Look* look = scene.look_of(part.solid);
  return part.attenuation > 0 && (!look || look->visible);
}

}  // namespace

bool shows_film_of_model(const Scene& scene, const GpuModel& model) {
  return scene.volume.shows_volume() && scene.volume.cast == VolumeLook::Cast::radiograph &&
         std::any_of(model.parts.begin(), model.parts.end(), [](const GpuPart& part) { return part.attenuation > 0; });
}

FilmPass::FilmPass(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl), shaders_(shaders), no_vertices_(make_vertex_array(gl)) {}

void FilmPass::draw(const FramePlan& plan, const GpuModel& model, const Scene& scene, const Framebuffer& picture) {
  if (!programs_)
    programs_ = Programs{Program(*gl_, shaders_, {"film_faces.vert", "film_faces.frag"}),
                         Program(*gl_, shaders_, {"fullscreen.vert", "film.frag"})};
  if (sums_.size() != plan.size) sums_ = Framebuffer(*gl_, {plan.size, {GL_RG32F}});
  const float middle = plan.parallel ? -(plan.view.world_to_eye * glm::vec4(model.centre, 1)).z
                                     : glm::length(glm::vec3(plan.view.world_to_eye * glm::vec4(model.centre, 1)));
  constexpr GLfloat nothing[4] = {0, 0, 0, 0};
  gl_->Disable(GL_SCISSOR_TEST);
  sums_.bind();
  gl_->ClearBufferfv(GL_COLOR, 0, nothing);
  for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE}) gl_->Disable(test);
  gl_->Enable(GL_BLEND);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFunc(GL_ONE, GL_ONE);
  const Program& faces = programs_->faces;
  faces.use();
  set_view(faces, plan);
  faces.set("middle", middle);
  for (const GpuPart& part : model.parts) {
    if (!counts(part, scene)) continue;
    faces.set("attenuation", metres_to_mm * part.attenuation);
    part.draw();
  }
  picture.bind();
  gl_->Disable(GL_BLEND);
  const Program& film = programs_->film;
  film.use();
  film.set("swallowed", 0);
  film.set("latitude", static_cast<float>(scene.volume.latitude));
  film.set("middle", middle);
  film.set("least", metres_to_mm * nothing_left);
  film.set("section", in_eye_space(plan.section, plan.view.world_to_eye));
  film.set("clip_to_eye", glm::inverse(plan.view.eye_to_clip));
  film.set("pixels", glm::vec2(plan.size.width, plan.size.height));
  film.set("parallel", plan.parallel ? 1 : 0);
  film.set("inverted", scene.volume.inverted ? 1 : 0);
  film.set("film", glm::vec2(scene.volume.film_mm) / metres_to_mm);
  film.set("film_centre", glm::vec3(plan.view.world_to_eye * glm::vec4(model.centre, 1)));
  sums_.bind_colour(0, 0);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace odontoscope
