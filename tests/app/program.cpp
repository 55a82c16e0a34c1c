#include "tests/app/program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace odontoscope::testing_support {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto longest_run = std::chrono::seconds(60);

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  void close_end(std::size_t end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }
  std::array<int, 2> ends{-1, -1};
};

[[noreturn]] void become_odontoscope(const Call& call, int out, int err) {
  std::vector<std::string> words{ODONTOSCOPE_PROGRAM};
  words.insert(words.end(), call.arguments.begin(), call.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  if (!call.out_to.empty()) out = ::open(call.out_to.c_str(), O_WRONLY);
  if (!call.err_to.empty()) err = ::open(call.err_to.c_str(), O_WRONLY);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (::chdir(call.folder.c_str()) == 0 && ::dup2(nothing, 0) == 0 && ::dup2(out, 1) == 1 && ::dup2(err, 2) == 2) {
    // Whoever started the tests may ignore them (nohup), and what is ignored stays ignored.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
    for (const auto& [variable, value] : call.environment)
      value.empty() ? ::unsetenv(variable.c_str()) : ::setenv(variable.c_str(), value.c_str(), 1);
    ::execv(argv[0], argv.data());
  }
  ::_exit(127);
}

/// Appends what is there; false at its end.
bool take(int descriptor, std::string& to) {
  std::array<char, 4096> buffer;
  const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
  if (count < 0 && errno == EINTR) return true;
  if (count <= 0) return false;
  to.append(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

/// Has the program taken that signal into its own hands (caught, or blocked and waited for)? On a busy machine it takes
/// a while to get so far.
bool handles(pid_t process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  if (!status) return true;  // no Linux: the pause must do
  for (std::string line; std::getline(status, line);)
    if ((line.starts_with("SigCgt:") || line.starts_with("SigBlk:")) &&
        (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0)
      return true;
  return false;
}

/// Sends the next of the signals when its time has come.
class SignalSender {
 public:
  SignalSender(const Call& call, pid_t process) : call_(call), process_(process) {
    if (call.says_nothing) due_ += call.pause;
  }
  void look(bool at_work) {
    if (next_ == call_.signals.size() || !at_work || Clock::now() < due_) return;
    if (call_.says_nothing && next_ == 0 && !handles(process_, call_.signals[0])) return;
    ::kill(process_, call_.signals[next_++]);
    due_ = Clock::now() + call_.pause;
  }

 private:
  const Call& call_;
  pid_t process_;
  std::size_t next_ = 0;
  Clock::time_point due_ = Clock::now();
};

void collect(const Call& call, pid_t process, Pipe& out, Pipe& err, Ending& ending) {
  const auto deadline = Clock::now() + longest_run;
  SignalSender signals(call, process);
  std::array<pollfd, 2> watched{pollfd{out.ends[0], POLLIN, 0}, pollfd{err.ends[0], POLLIN, 0}};
  const std::array<std::string*, 2> texts{&ending.out, &ending.err};
  while (watched[0].fd >= 0 || watched[1].fd >= 0) {
    constexpr int timeout_ms = 20;
    ::poll(watched.data(), watched.size(), timeout_ms);
    for (std::size_t i = 0; i < watched.size(); ++i) {
      if (watched[i].fd >= 0 && watched[i].revents != 0 && !take(watched[i].fd, *texts[i])) watched[i].fd = -1;
    }
    signals.look(call.says_nothing || !ending.err.empty());
    if (Clock::now() > deadline) {
      ::kill(process, SIGKILL);
      ADD_FAILURE() << "the program did not end within a minute";
      return;
    }
  }
}

}  // namespace

Ending run(const Call& call) {
  Pipe out, err;
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("no process");
  if (process == 0) become_odontoscope(call, out.ends[1], err.ends[1]);
  out.close_end(1);
  err.close_end(1);
  Ending ending;
  collect(call, process, out, err, ending);
  int status = 0;
  ::waitpid(process, &status, 0);
  if (WIFEXITED(status)) ending.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  return ending;
}

std::string cube_stack(const std::string& points) {
  return R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[)"
         R"({"z":0,"contours":[{"structure":"tooth","points":[[0,0],[1,0],[1,1],[0,1]]}]},)"
         R"({"z":1,"contours":[{"structure":"tooth","points":)" +
         points + "}]}]}\n";
}

}  // namespace odontoscope::testing_support
