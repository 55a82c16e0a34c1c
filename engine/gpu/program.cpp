#include "engine/gpu/program.h"

#include <fmt/format.h>

#include <glm/gtc/type_ptr.hpp>
#include <sstream>

#include "recon/core/error.h"

namespace odontoscope {

namespace {

constexpr const char* glsl_version = "#version 410 core\n";

std::string numbered(const std::string& source) {
  std::istringstream lines(source);
  std::string result, line;
  for (int number = 1; std::getline(lines, line); ++number) result += fmt::format("{:4} {}\n", number, line);
  return result;
}

GlObject compile(const Gl& gl, const ShaderLibrary& shaders, GLenum stage, std::string_view name,
                 const ProgramFiles& files) {
  std::string source = glsl_version;
  for (const std::string_view define : files.defines) source += fmt::format("#define {}\n", define);
  source += shaders.source(name);
  GlObject shader(gl, gl.CreateShader(stage), [](const Gl& table, GLuint dead) { table.DeleteShader(dead); });
  const char* text = source.c_str();
  gl.ShaderSource(shader.id(), 1, &text, nullptr);
  gl.CompileShader(shader.id());
  GLint compiled = GL_FALSE, length = 0;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  gl.GetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), ' ');
  gl.GetShaderInfoLog(shader.id(), length, nullptr, log.data());
  throw InternalError(fmt::format("shader {} does not compile:\n{}\n{}", name, log.c_str(), numbered(source)));
}

std::map<std::string, GLint, std::less<>> uniform_locations(const Gl& gl, GLuint program) {
  std::map<std::string, GLint, std::less<>> locations;
  GLint count = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    gl.GetActiveUniform(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
    locations[name] = gl.GetUniformLocation(program, name);
  }
  return locations;
}

}  // namespace

Program::Program(const Gl& gl, const ShaderLibrary& shaders, const ProgramFiles& files)
    : program_(gl, gl.CreateProgram(), [](const Gl& table, GLuint dead) { table.DeleteProgram(dead); }) {
  std::vector<GlObject> stages;
  stages.push_back(compile(gl, shaders, GL_VERTEX_SHADER, files.vertex, files));
  if (!files.geometry.empty()) stages.push_back(compile(gl, shaders, GL_GEOMETRY_SHADER, files.geometry, files));
  stages.push_back(compile(gl, shaders, GL_FRAGMENT_SHADER, files.fragment, files));
  for (const GlObject& stage : stages) gl.AttachShader(program_.id(), stage.id());
  gl.LinkProgram(program_.id());
  for (const GlObject& stage : stages) gl.DetachShader(program_.id(), stage.id());
  GLint linked = GL_FALSE, length = 0;
  gl.GetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
  if (!linked) {
    gl.GetProgramiv(program_.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length) + 1, ' ');
    gl.GetProgramInfoLog(program_.id(), length, nullptr, log.data());
    throw InternalError(fmt::format("{} and {} do not link:\n{}", files.vertex, files.fragment, log.c_str()));
  }
  locations_ = uniform_locations(gl, program_.id());
}

GLint Program::location(const char* uniform) const {
  const auto found = locations_.find(std::string_view(uniform));
  return found == locations_.end() ? -1 : found->second;
}

void Program::set(const char* uniform, int value) const { program_.gl().Uniform1i(location(uniform), value); }
void Program::set(const char* uniform, float value) const { program_.gl().Uniform1f(location(uniform), value); }
void Program::set(const char* uniform, const glm::ivec2& value) const {
  program_.gl().Uniform2iv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec2& value) const {
  program_.gl().Uniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec3& value) const {
  program_.gl().Uniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec4& value) const {
  program_.gl().Uniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat3& value) const {
  program_.gl().UniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) const {
  program_.gl().UniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace odontoscope
