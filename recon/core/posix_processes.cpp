#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "recon/core/system_processes.h"

namespace odontoscope::system {
namespace {

constexpr std::array standard_files = {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO};
constexpr std::array requests_to_end = {SIGINT, SIGTERM, SIGHUP};

std::size_t own_address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Those of the requests that were not ignored when the program started.
sigset_t heeded_requests() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : requests_to_end) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  return signals;
}

// --- in a child between fork and exec: system calls alone ------------------------------------------------------------

/// Whatever this program catches or ignores is none of the child's business.
void reset_signals() {
  for (const int signal :
       {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGXCPU, SIGXFSZ})
    ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void limit(int what, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<__rlimit_resource_t>(what), &both);
}

void bind(const ChildLimits& limits) {
  limit(RLIMIT_CORE, 0);
  if (limits.processor_seconds > 0) limit(RLIMIT_CPU, limits.processor_seconds);
  if (limits.bytes > 0) limit(RLIMIT_AS, limits.bytes);
}

[[noreturn]] void become_this_program(char* const* argv, int errors, const ChildLimits& limits) {
  ::setpgid(0, 0);  // so that its own children end with it
  reset_signals();
  bind(limits);
  const int nothing = ::open("/dev/null", O_RDWR);
  if (::dup2(nothing, STDIN_FILENO) >= 0 && ::dup2(nothing, STDOUT_FILENO) >= 0 && ::dup2(errors, STDERR_FILENO) >= 0)
    ::execv("/proc/self/exe", argv);
  constexpr int no_program = 127;
  ::_exit(no_program);
}

[[noreturn]] void be_worker(const std::function<void()>& work, const ChildLimits& limits, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  reset_signals();
  bind(limits);
  limit(RLIMIT_FSIZE, 0);
  const int nothing = ::open("/dev/null", O_RDWR);
  for (const int standard : standard_files) ::dup2(nothing, standard);
  try {
    work();
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// What a program is started with; all of it is given back.
struct SpawnOptions {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;

  SpawnOptions() {
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnOptions() {
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
  }
  SpawnOptions(const SpawnOptions&) = delete;
  SpawnOptions& operator=(const SpawnOptions&) = delete;
};

}  // namespace

// --- this process ----------------------------------------------------------------------------------------------------

int own_number() { return ::getpid(); }

bool runs(int process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

double memory_left_by_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::numeric_limits<double>::infinity();
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - static_cast<double>(own_address_space()));
}

bool is_administrator() { return ::geteuid() == 0; }

void set_environment(const char* name, const char* value) { ::setenv(name, value, 0); }

void occupy_closed_standard_files() {
  for (const int standard : standard_files)
    if (::fcntl(standard, F_GETFD) < 0) (void)!::open("/dev/null", O_RDONLY);
}

void let_writes_fail() {
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

bool errors_go_to_terminal() { return ::isatty(STDERR_FILENO) != 0; }

std::optional<int> terminal_columns() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

void* open_library(const char* file, std::string& trouble) {
  void* const library = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) trouble = ::dlerror();
  return library;
}

void* symbol(void* library, const char* name) { return ::dlsym(library, name); }

// --- being asked to end ----------------------------------------------------------------------------------------------

void hold_requests_to_end() {
  const sigset_t signals = heeded_requests();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

void wait_to_be_asked_to_end() {
  sigset_t signals = heeded_requests();
  sigaddset(&signals, SIGTERM);  // also where it is ignored: it is what wake() sends
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0) {
  }
}

// One thread alone waits for it, see above: NOLINTNEXTLINE(bugprone-bad-signal-to-kill-thread)
void wake(std::thread& waiting) { ::pthread_kill(waiting.native_handle(), SIGTERM); }

// --- other processes -------------------------------------------------------------------------------------------------

Connection connect() {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return {};
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::ptrdiff_t send_within(const Descriptor& to, const char* bytes, std::size_t count, int milliseconds) {
  pollfd ready{to.number(), POLLOUT, 0};
  if (::poll(&ready, 1, milliseconds) <= 0) return nothing_yet;
  const ssize_t sent = ::send(to.number(), bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent >= 0) return sent;
  return errno == EINTR || errno == EAGAIN ? nothing_yet : -1;
}

std::string file_of_descriptor(int number) { return fmt::format("/dev/fd/{}", number); }

std::string Ending::in_words() const {
  return signal != 0 ? fmt::format("was ended by signal {}", signal)
                     : fmt::format("ended with exit code {}", exit_code);
}

Process::~Process() {
  if (!runs()) return;
  kill();
  bury(Wait::until_over);
}

bool Process::start(std::vector<std::string> words, const std::vector<std::pair<const Descriptor*, int>>& files) {
  constexpr int beyond_the_childs = 16;  // so that none is in another's way while they get their numbers
  SpawnOptions options;
  ::posix_spawn_file_actions_addopen(&options.files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&options.files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<Descriptor> moved;
  for (const auto& [here, there] : files) {
    moved.emplace_back(::fcntl(here->number(), F_DUPFD_CLOEXEC, beyond_the_childs));
    if (!moved.back().is_open()) return false;
    ::posix_spawn_file_actions_adddup2(&options.files, moved.back().number(), there);
  }
  const std::vector<char*> argv = pointers_to(words);
  errno = ::posix_spawnp(&number_, argv.front(), &options.files, &options.attributes, argv.data(), environ);
  if (errno != 0) number_ = -1;
  leads_group_ = true;
  return runs();
}

bool Process::start_this_program(const std::vector<std::string>& arguments, const Descriptor& errors,
                                 const ChildLimits& limits) {
  std::vector<std::string> words{"odontoscope"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = pointers_to(words);
  number_ = ::fork();
  if (number_ == 0) become_this_program(argv.data(), errors.number(), limits);
  if (runs()) ::setpgid(number_, number_);
  leads_group_ = true;
  return runs();
}

bool Process::start_work(const std::function<void()>& work, const ChildLimits& limits) {
  ChildLimits all = limits;
  if (limits.bytes > 0) all.bytes += own_address_space();
  const pid_t parent = ::getpid();
  number_ = ::fork();
  if (number_ == 0) be_worker(work, all, parent);
  return runs();
}

void Process::kill() { ::kill(leads_group_ ? -number_ : number_, SIGKILL); }

std::optional<Ending> Process::bury(Wait how) {
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  do {
    ended = ::wait4(number_, &status, how == Wait::until_over ? 0 : WNOHANG, &usage);
  } while (ended < 0 && errno == EINTR);
  if (ended == 0) return std::nullopt;
  if (ended > 0 && leads_group_) kill();  // what it left behind
  number_ = -1;
  Ending ending;
  if (ended < 0) return ending;
  if (WIFEXITED(status)) ending.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  ending.peak_bytes = static_cast<double>(usage.ru_maxrss) * 1024;
  return ending;
}

std::optional<Ending> Process::ended() { return bury(Wait::no); }

Ending Process::wait() { return *bury(Wait::until_over); }

void end_at_once(int exit_code) { ::_exit(exit_code); }

}  // namespace odontoscope::system
