#include "recon/volume/decode_apart.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/byte_source.h"

namespace odontoscope {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool memory_is_bounded = false;  // sanitizers reserve the address space
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool memory_is_bounded = false;
#else
constexpr bool memory_is_bounded = true;
#endif
#else
constexpr bool memory_is_bounded = true;
#endif

/// Memory that a child writes and its parent reads.
class SharedBytes {
 public:
  explicit SharedBytes(std::size_t size) : size_(size) {
    bytes_ = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (bytes_ == MAP_FAILED) throw std::bad_alloc();
  }
  ~SharedBytes() { ::munmap(bytes_, size_); }
  SharedBytes(const SharedBytes&) = delete;
  SharedBytes& operator=(const SharedBytes&) = delete;
  char* at(std::size_t offset) const { return static_cast<char*>(bytes_) + offset; }

 private:
  std::size_t size_;
  void* bytes_;
};

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

void bind(rlim_t address_space, std::size_t frames) {
  const rlim_t seconds = limits::decoding_seconds * (frames + 1);
  const rlimit time{seconds, seconds}, none{0, 0};
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

[[noreturn]] void be_child(const std::vector<CompressedFrame>& frames, const SharedBytes& shared, std::size_t each, int told, pid_t parent, rlim_t address_space) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  reset_signals();
  bind(address_space, frames.size());
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int standard : {0, 1, 2}) ::dup2(nowhere, standard);  // decoders write there as they please
  for (std::size_t n = 0; n < frames.size(); ++n) {
    char good = 0;
    try {
      good = decode_here(frames[n], shared.at(n * each)) ? 1 : 0;
    } catch (...) {
    }
    if (::write(told, &good, 1) != 1 || good == 0) ::_exit(1);
  }
  ::_exit(0);
}

/// Kills and buries the child, unless it is dead already.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  ~Child() {
    ::kill(id_, SIGKILL);
    while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

 private:
  pid_t id_;
};

/// How many frames the child told that it finished, until it ends or takes too long.
std::size_t finished(int told, std::size_t count, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  constexpr int look_every = 100;  // milliseconds
  auto last = Clock::now();
  for (std::size_t done = 0; done < count;) {
    progress.check();
    pollfd waiting{told, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, look_every);
    if (ready > 0) {
      char good = 0;
      const ssize_t got = ::read(told, &good, 1);
      if (got < 0 && errno == EINTR) continue;
      if (got != 1 || good != 1) return done;
      ++done;
      last = Clock::now();
    }
    if (Clock::now() - last > std::chrono::seconds(limits::decoding_seconds_by_clock)) return done;
    if (done == count) return done;
  }
  return count;
}

rlim_t address_space_of_child(std::size_t frame_bytes) {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + limits::decoding_bytes + 8 * frame_bytes;
}

}  // namespace

std::vector<std::string> decode_apart(const std::vector<CompressedFrame>& frames, const Progress& progress) {
  if (frames.empty()) return {};
  const std::size_t each = frames.front().decoded_bytes();
  const SharedBytes shared(each * frames.size());
  const rlim_t address_space = address_space_of_child(each);
  Pipe pipe;
  const pid_t parent = ::getpid(), id = ::fork();
  if (id < 0) throw FileError(frames.front().file, fmt::format("cannot be decoded: no process can be started ({})", std::strerror(errno)), "end other programs");
  if (id == 0) be_child(frames, shared, each, pipe.ends[1], parent, address_space);
  const Child child(id);
  Pipe::shut(pipe.ends[1]);
  const std::size_t done = finished(pipe.ends[0], frames.size(), progress);
  if (done < frames.size()) {
    throw InputError("damaged-volume", in_file(frames[done].file), "its compressed pixels cannot be decoded", "get a whole copy of the file, or store it uncompressed");
  }
  std::vector<std::string> decoded;
  for (std::size_t n = 0; n < frames.size(); ++n) decoded.emplace_back(shared.at(n * each), each);
  return decoded;
}

}  // namespace odontoscope
