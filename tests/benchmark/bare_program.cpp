#include "tests/benchmark/bare_program.h"

#include <glm/gtc/type_ptr.hpp>

#include "engine/gpu/graphics_error.h"

namespace odontoscope {

namespace {

constexpr const char* vertex_source = R"(#version 410 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 world_to_clip;
uniform mat4 world_to_eye;
out vec3 eye_normal;
void main() {
  eye_normal = mat3(world_to_eye) * normal;
  gl_Position = world_to_clip * vec4(position, 1.0);
}
)";

constexpr const char* fragment_source = R"(#version 410 core
in vec3 eye_normal;
layout(location = 0) out vec4 colour;
void main() {
  float light = max(dot(normalize(eye_normal), vec3(0.0, 0.6, 0.8)), 0.0);
  colour = vec4(vec3(0.9, 0.8, 0.7) * (0.2 + 0.8 * light), 1.0);
}
)";

void attach(const Gl& gl, GLuint program, GLenum kind, const char* source) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);
}

}  // namespace

BareProgram::BareProgram(const Gl& gl, PixelSize size)
    : gl_(&gl),
      program_(gl, gl.CreateProgram(), [](const Gl& table, GLuint id) { table.DeleteProgram(id); }),
      pixels_(gl, {size, {GL_RGBA8}, GL_DEPTH_COMPONENT32F}) {
  attach(gl, program_.id(), GL_VERTEX_SHADER, vertex_source);
  attach(gl, program_.id(), GL_FRAGMENT_SHADER, fragment_source);
  gl.LinkProgram(program_.id());
  GLint linked = 0;
  gl.GetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
  if (!linked) throw InternalError("the bare program does not link");
}

void BareProgram::draw(const GpuModel& model, const View& view, bool culled) const {
  pixels_.bind();
  gl_->ClearColor(0.8f, 0.85f, 0.9f, 1);
  gl_->DepthMask(GL_TRUE);
  gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->Disable(GL_BLEND);
  gl_->CullFace(GL_BACK);
  if (culled)
    gl_->Enable(GL_CULL_FACE);
  else
    gl_->Disable(GL_CULL_FACE);
  gl_->UseProgram(program_.id());
  const glm::mat4 to_clip = view.eye_to_clip * view.world_to_eye;
  gl_->UniformMatrix4fv(gl_->GetUniformLocation(program_.id(), "world_to_clip"), 1, GL_FALSE, glm::value_ptr(to_clip));
  gl_->UniformMatrix4fv(gl_->GetUniformLocation(program_.id(), "world_to_eye"), 1, GL_FALSE,
                        glm::value_ptr(view.world_to_eye));
  for (const GpuPart& part : model.parts) part.draw();
}

}  // namespace odontoscope
