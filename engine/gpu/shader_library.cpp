#include "engine/gpu/shader_library.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "recon/core/error.h"

namespace odontoscope {

namespace {

constexpr int deepest_include = 4;
constexpr std::string_view include_start = "#include \"";

std::string text_of(const std::filesystem::path& folder, std::string_view name) {
  if (folder.empty()) {
    for (const EmbeddedFile& shader : embedded_shaders())
      if (shader.name == name) return std::string(shader.bytes);
    throw InternalError(fmt::format("there is no shader {}", name));
  }
  const std::filesystem::path file = folder / name;
  std::ifstream stream(file);
  if (!stream) throw FileError(file.string(), "the shader cannot be read", "Check ODONTOSCOPE_SHADERS.");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string expanded(const std::filesystem::path& folder, std::string_view name, int depth) {
  if (depth > deepest_include) throw InternalError(fmt::format("shaders include each other: {}", name));
  std::istringstream lines(text_of(folder, name));
  std::string result, line;
  while (std::getline(lines, line)) {
    if (line.starts_with(include_start)) {
      const std::size_t end = line.find('"', include_start.size());
      result +=
          expanded(folder, std::string_view(line).substr(include_start.size(), end - include_start.size()), depth + 1);
    } else {
      result += line + '\n';
    }
  }
  return result;
}

}  // namespace

std::string ShaderLibrary::source(std::string_view name) const { return expanded(folder, name, 0); }

ShaderLibrary shaders_from_environment() {
  const char* folder = std::getenv("ODONTOSCOPE_SHADERS");
  return {folder ? std::filesystem::path(folder) : std::filesystem::path()};
}

}  // namespace odontoscope
