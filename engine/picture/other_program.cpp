#include "engine/picture/other_program.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "recon/core/system_files.h"

namespace odontoscope {

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return {};
  const std::size_t start = text.find_last_of("\r\n", end);
  const std::size_t first = start == std::string::npos ? 0 : start + 1;
  std::string line = text.substr(first, end - first + 1);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  constexpr std::size_t most = 300;
  return line.substr(0, most);
}

std::string program_in_path(const std::vector<std::string>& names) {
  const char* const variable = std::getenv("PATH");
  const std::string folders = variable == nullptr ? "" : variable;
  for (const std::string& name : names)
    for (std::size_t at = 0; at <= folders.size();) {
      const std::size_t end = std::min(folders.find(':', at), folders.size());
      const std::filesystem::path program = std::filesystem::path(folders.substr(at, end - at)) / name;
      std::error_code error;
      if (end > at && std::filesystem::is_regular_file(program, error) && system::may_run(program))
        return program.string();
      at = end + 1;
    }
  return {};
}

}  // namespace odontoscope
