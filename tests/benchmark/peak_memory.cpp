#include "tests/benchmark/peak_memory.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope {
namespace {

/// A line of /proc/self/status in bytes; 0 if it is not there.
std::size_t status(const std::string& key) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key + ":")) return std::stoul(line.substr(key.size() + 1)) * 1024;
  return 0;
}

PeakMemory measure(const std::function<ContourStack()>& make, int threads) {
  PeakMemory memory;
  const ContourStack stack = make();
  std::ofstream("/proc/self/clear_refs") << "5";  // from here on VmHWM counts anew
  memory.contours = status("VmRSS");
  const auto start = std::chrono::steady_clock::now();
  const Reconstruction result =
      reconstruct(stack, {.correspondence = Correspondence::medial, .links = {}, .threads = threads});
  memory.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  memory.peak = status("VmHWM");
  memory.measured = result.certified && memory.peak > 0;
  return memory;
}

}  // namespace

PeakMemory peak_memory(const std::function<ContourStack()>& make, int threads) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    PeakMemory memory;
    try {
      memory = measure(make, threads);
    } catch (...) {
    }
    const bool told = write(ends[1], &memory, sizeof memory) == sizeof memory;
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  PeakMemory memory;
  const bool heard = child > 0 && read(ends[0], &memory, sizeof memory) == sizeof memory;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return heard ? memory : PeakMemory{};
}

}  // namespace odontoscope
