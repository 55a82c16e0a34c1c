#include "recon/compare/peak_memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <fstream>
#include <string>

namespace odontoscope {
namespace {

/// A line of /proc/self/status in bytes; 0 if it is not there.
std::size_t status(const std::string& key) {
  constexpr std::size_t kibi = 1024;
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key + ":")) return std::stoul(line.substr(key.size() + 1)) * kibi;
  }
  return 0;
}

}  // namespace

std::optional<std::size_t> peak_memory_of(const std::function<void()>& work) {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
  const bool reset =
      static_cast<bool>(std::ofstream("/proc/self/clear_refs") << "5" << std::flush);  // VmHWM counts anew
  const std::size_t before = status("VmRSS");
  work();
  const std::size_t peak = status("VmHWM");
  if (!reset || before == 0 || peak < before) return std::nullopt;
  return peak - before;
}

}  // namespace odontoscope
