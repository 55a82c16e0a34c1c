#include "recon/core/work_apart.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

#include "recon/core/error.h"
#include "recon/core/sanitized.h"

namespace odontoscope {
namespace {

constexpr bool memory_is_bounded = !address_sanitized && !thread_sanitized;

struct Pipe {
  int ends[2] = {-1, -1};
  Pipe() {
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::bad_alloc();
  }
  ~Pipe() {
    for (int& end : ends) shut(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  static void shut(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }
};

void bind(const ApartLimits& limits, rlim_t address_space) {
  const rlimit time{limits.processor_seconds, limits.processor_seconds}, none{0, 0};
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_CORE, &none);
  ::setrlimit(RLIMIT_FSIZE, &none);
  if (!memory_is_bounded) return;
  const rlimit memory{address_space, address_space};
  ::setrlimit(RLIMIT_AS, &memory);
}

/// Signals as a new program has them: whatever this one catches is none of the child's business.
void reset_signals() {
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGXCPU}) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void be_child(const std::function<void(const SendToParent&)>& work, const ApartLimits& limits, rlim_t address_space, int to_parent, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  reset_signals();
  bind(limits, address_space);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int standard : {0, 1, 2}) ::dup2(nowhere, standard);
  try {
    work([to_parent](const char* bytes, std::size_t count) {
      while (count > 0) {
        const ssize_t written = ::write(to_parent, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) ::_exit(1);
        bytes += written;
        count -= static_cast<std::size_t>(written);
      }
    });
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

/// Kills and buries the child, unless that was done.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  ~Child() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    bury();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Of a child that has shut its end of the pipe.
  bool ended_well() {
    const int status = bury();
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  int bury() {
    int status = -1;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = 0;
    return status;
  }
  pid_t id_;
};

/// Reads until the child shuts its end or says nothing for too long. True: it shut its end.
bool listen(int from_child, unsigned silent_seconds, std::string& sent, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  constexpr int look_every = 100;  // milliseconds
  std::array<char, 1 << 16> piece;
  for (auto last = Clock::now();;) {
    progress.check();
    pollfd waiting{from_child, POLLIN, 0};
    if (::poll(&waiting, 1, look_every) > 0) {
      const ssize_t got = ::read(from_child, piece.data(), piece.size());
      if (got == 0) return true;
      if (got > 0) sent.append(piece.data(), static_cast<std::size_t>(got)), last = Clock::now();
      else if (errno != EINTR) return false;
    }
    if (Clock::now() - last > std::chrono::seconds(silent_seconds)) return false;
  }
}

rlim_t address_space_of_child(std::size_t bytes) {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + bytes;
}

}  // namespace

DoneApart work_apart(const std::function<void(const SendToParent&)>& work, const ApartLimits& limits, const Progress& progress) {
  const rlim_t address_space = address_space_of_child(limits.bytes);
  Pipe pipe;
  const pid_t parent = ::getpid(), id = ::fork();
  if (id < 0) throw FileError("", fmt::format("no process can be started ({})", std::strerror(errno)), "End other programs");
  if (id == 0) be_child(work, limits, address_space, pipe.ends[1], parent);
  Child child(id);
  Pipe::shut(pipe.ends[1]);
  DoneApart done;
  done.whole = listen(pipe.ends[0], limits.silent_seconds, done.sent, progress) && child.ended_well();
  return done;
}

}  // namespace odontoscope
