#pragma once
// What the operating system is asked for about processes, signals and the terminal; see system_files.h.
//
// Whatever fails leaves errno set, unless it says otherwise.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "recon/core/system_files.h"

namespace odontoscope::system {

// --- this process ----------------------------------------------------------------------------------------------------

int own_number();
/// Also where it belongs to somebody else.
bool runs(int process);
/// Bytes of memory that a limit on this process leaves; infinite without one.
double memory_left_by_limit();
/// Is the user the machine's administrator, whom browsers refuse their sandbox?
bool is_administrator();
/// Unless it has a value.
void set_environment(const char* name, const char* value);

/// A program that was started with standard output closed would give its number to the next file that it opens, and
/// write its words into a model. What stands there instead takes no words, so that writing them fails.
void occupy_closed_standard_files();
/// A reader that went away, or a limit on the size of files, makes a write fail, and does not end the program in the
/// middle of its files.
void let_writes_fail();

bool errors_go_to_terminal();
/// Nothing if that is not known.
std::optional<int> terminal_columns();

/// Opens a shared library; it stays open. Null, and what is wrong, if it cannot be.
void* open_library(const char* file, std::string& trouble);
void* symbol(void* library, const char* name);

// --- being asked to end ----------------------------------------------------------------------------------------------

/// Ctrl-C, and the signals by which a system asks a program to end, come to wait_to_be_asked_to_end from here on: in
/// this thread, and in those that it starts. One that was ignored when the program started (nohup, background jobs)
/// stays so.
void hold_requests_to_end();
/// Waits for the next of them, or until wake() is called with this thread.
void wait_to_be_asked_to_end();
void wake(std::thread& waiting);

// --- other processes -------------------------------------------------------------------------------------------------

/// Two ends of one. Nobody at the other end is an error, and no signal that ends us. Both may be none.
struct Connection {
  Descriptor ours, childs;
};
Connection connect();

/// Sends some of these bytes: how many; -1 if nobody reads any more, `nothing_yet` if none were taken in that time.
std::ptrdiff_t send_within(const Descriptor& to, const char* bytes, std::size_t count, int milliseconds);

/// Where a child finds the descriptor that has this number there, as a file's name.
std::string file_of_descriptor(int number);

struct Ending {
  int exit_code = -1;     // -1 if it did not exit by itself
  int signal = 0;         // that ended it
  double peak_bytes = 0;  // of memory, resident
  /// "was ended by signal 9", "ended with exit code 1".
  std::string in_words() const;
};

/// What a child may take.
struct ChildLimits {
  std::size_t bytes = 0;           // of memory, for a copy of this process beyond what it has; 0: unlimited
  unsigned processor_seconds = 0;  // 0: unlimited
};

/// A child. It, and where it has a group of its own what it started, end with the owner.
class Process {
 public:
  Process() = default;
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// `words`: the program, looked for in PATH unless it has a slash, and its arguments. `files`: descriptors here, and
  /// the numbers that they have there; standard input, output and errors are as `files` say, else empty, dropped and
  /// ours. A process group of its own, so that Ctrl-C is ours alone; no signal is blocked.
  bool start(std::vector<std::string> words, const std::vector<std::pair<const Descriptor*, int>>& files);

  /// This very program with other arguments and in a process group of its own; what it says on standard error goes to
  /// `errors`, all else nowhere.
  bool start_this_program(const std::vector<std::string>& arguments, const Descriptor& errors,
                          const ChildLimits& limits);

  /// A copy of this process that does `work` and is over: well if it returns. Of the threads it has the calling one
  /// alone. No file can grow in it, it says nothing, and it ends with this process.
  bool start_work(const std::function<void()>& work, const ChildLimits& limits);

  bool runs() const { return number_ > 0; }
  /// How it ended, once it has; an exit code of -1 and no signal if that is not known. Precondition: it runs.
  std::optional<Ending> ended();
  /// Waits for its end. Precondition: it runs.
  Ending wait();
  void kill();

 private:
  enum class Wait { no, until_over };
  std::optional<Ending> bury(Wait wait);

  int number_ = -1;
  bool leads_group_ = false;
};

/// In a child: over, with nothing that its parent left to be done at the end.
[[noreturn]] void end_at_once(int exit_code);

}  // namespace odontoscope::system
