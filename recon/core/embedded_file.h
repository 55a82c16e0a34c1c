#pragma once
// A file that was made part of the program when it was built: cmake/embed.cmake.

#include <span>
#include <string_view>

namespace odontoscope {

struct EmbeddedFile {
  std::string_view name;  // without folders
  std::string_view bytes;
};

}  // namespace odontoscope
