#include "tests/hostile/bounded.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <new>
#include <stdexcept>

#include "recon/core/error.h"
#include "recon/core/sanitized.h"

namespace odontoscope::hostile {
namespace {

std::size_t bytes_held() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void bind_to(const Bounds& bounds) {
  const rlimit time{bounds.seconds, bounds.seconds};
  ::setrlimit(RLIMIT_CPU, &time);
  if (address_sanitized) return;
  const rlim_t most = bytes_held() + (bounds.megabytes << 20);
  const rlimit memory{most, most};
  ::setrlimit(RLIMIT_AS, &memory);
}

std::string outcome(const std::function<void()>& action) {
  try {
    action();
    return "accepted";
  } catch (const InputError& error) {
    return error.cause();
  } catch (const FileError&) {
    return "cannot be read";
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return std::string("threw ") + error.what();
  }
}

}  // namespace

std::string outcome_within(const Bounds& bounds, const std::function<void()>& action) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    bind_to(bounds);
    const std::string said = outcome(action);
    const bool told = ::write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size());
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  std::string said;
  char buffer[256];
  for (ssize_t got; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;)
    said.append(buffer, static_cast<std::size_t>(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) {
    // The kernel's limit of time ends a process by SIGXCPU, or SIGKILL where both limits are the same.
    const bool late = WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL;
    return late ? "out of time" : "ended by signal " + std::to_string(WTERMSIG(status));
  }
  return said;
}

}  // namespace odontoscope::hostile
