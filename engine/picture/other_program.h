#pragma once
// Another program that is started and spoken to through descriptors: ffmpeg, a browser.

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace odontoscope {

/// An open file that goes with its owner. Never one of those that a child gets its own under.
class Descriptor {
 public:
  /// Takes what was opened; nothing, if it is negative.
  explicit Descriptor(int opened);
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void close();
  int number() const { return number_; }  // negative: none

 private:
  int number_ = -1;
};

/// Two ends that are one. A connection and not a pipe: nobody at the other end is an error, and no signal that ends us.
/// Both may be none.
struct Connection {
  Descriptor ours, childs;
  Connection();

 private:
  explicit Connection(std::pair<int, int> ends) : ours(ends.first), childs(ends.second) {}
};

/// A file without a name, open for reading and writing; negative: there can be none.
int nameless_file();

/// All that was written to such a file.
std::string all_bytes(int descriptor);

/// Of what a program said: that is most often what is wrong. Control characters become blanks.
std::string last_line(const std::string& text);

/// A program that runs in a process group of its own, so that Ctrl-C is ours alone, with no signal blocked. It, and
/// what it started, end with the owner.
class OtherProgram {
 public:
  ~OtherProgram();
  OtherProgram() = default;
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  /// `words`: the program, looked for in PATH unless it has a slash, and its arguments. `files`: descriptors here, and
  /// the numbers that they have there; standard input and output are empty unless they are among them. Returns the
  /// error's number, or 0.
  int start(std::vector<std::string> words, const std::vector<std::pair<int, int>>& files);

  bool runs() const { return child_ > 0; }
  /// True once it has ended, with its status as waitpid gives it; -1, and errno says why, where that is not known.
  /// Precondition: it runs.
  bool ended(int& status);

 private:
  pid_t child_ = -1;
};

/// The first of these programs that PATH has, with its folder; empty: none.
std::string program_in_path(const std::vector<std::string>& names);

}  // namespace odontoscope
