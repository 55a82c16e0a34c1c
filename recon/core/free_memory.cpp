#include "recon/core/free_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "recon/core/error.h"
#include "recon/core/system_processes.h"

namespace odontoscope {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// Bytes that Linux thinks can be had without swapping.
double available_on_machine() {
  std::ifstream in("/proc/meminfo");
  for (std::string key, unit; in >> key;) {
    double kibibytes = 0;
    in >> kibibytes;
    if (key == "MemAvailable:") return in ? kibibytes * 1024 : unknown;
    std::getline(in, unit);
  }
  return unknown;
}

}  // namespace

void check_memory(const std::string& file, double bytes, std::string_view remedy) {
  const double there = std::min(available_on_machine(), system::memory_left_by_limit());
  if (bytes <= there) return;
  constexpr double megabyte = 1e6;
  throw FileError(file,
                  fmt::format("would take {:.0f} MB of memory, and this machine has {:.0f} MB left", bytes / megabyte,
                              there / megabyte),
                  remedy);
}

}  // namespace odontoscope
