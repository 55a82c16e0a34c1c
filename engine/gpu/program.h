#pragma once
// A linked shader program. A shader that fails to compile throws with its numbered source.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gpu/gl_object.h"
#include "engine/gpu/shader_library.h"

namespace odontoscope {

struct ProgramFiles {
  std::string_view vertex;
  std::string_view fragment;
  std::string_view geometry = {};  // none
  /// Names to #define, e.g. "PEEL".
  std::vector<std::string_view> defines = {};
};

class Program {
 public:
  Program() = default;
  /// Throws InternalError with the driver's words and the numbered source.
  Program(const Gl& gl, const ShaderLibrary& shaders, const ProgramFiles& files);

  void use() const { program_.gl().UseProgram(program_.id()); }
  // Uniforms of the program in use; one that the shader does not need is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::ivec2& value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat3& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

 private:
  GLint location(const char* uniform) const;
  GlObject program_;
  std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace odontoscope
