#pragma once
// Where the text of shaders comes from: embedded in the program, or a folder while developing.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "recon/core/embedded_file.h"

namespace odontoscope {

/// The files of shaders/ as they were when the program was built.
std::span<const EmbeddedFile> embedded_shaders();

struct ShaderLibrary {
  /// Empty: the embedded shaders. Otherwise files of this folder, read again each time.
  std::filesystem::path folder;

  /// The text of a shader with lines `#include "other.glsl"` replaced by that file. Throws FileError, or InternalError
  /// for a name that is not embedded or files that include each other.
  std::string source(std::string_view name) const;
};

/// The folder named by the environment variable ODONTOSCOPE_SHADERS, if it is set; otherwise the embedded shaders.
ShaderLibrary shaders_from_environment();

}  // namespace odontoscope
