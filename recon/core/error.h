#pragma once
// Errors that a user can cause or meet, each a value with a cause, a place and a remedy.
//
// Bad data is never repaired in silence and never crashes: it is thrown as one of the classes below, and nothing
// that existed before the call has changed. A broken invariant of our own is an InternalError.
// The program's exit code follows from the class (see ExitCode).

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "recon/core/geometry.h"

namespace odontoscope {

enum class ExitCode : int {
  done = 0,
  found_wanting = 1,  // checked, and it is no closed oriented manifold
  usage = 2,
  bad_input = 3,
  file = 4,       // could not read or write
  graphics = 5,   // no display, no OpenGL, or too old a one
  internal = 70,  // our bug
};

/// Where in the user's data the trouble is. Slices are counted from 0 in the order of the file, contours from 0
/// within their slice, points from 0 within their contour. What is not known stays empty.
struct Place {
  std::string file;
  std::optional<std::size_t> slice;
  std::optional<double> z;
  std::optional<std::size_t> contour;
  std::optional<std::size_t> point;
  std::optional<Point2> at;
  std::optional<std::size_t> line;  // of a text file, from 1
  std::optional<std::size_t> byte;  // offset in a binary file, from 0

  /// "teeth.json: slice 3 (z = 1.5), contour 2, point 17 at (1.25, 3)"; empty if nothing is known.
  std::string in_words() const;
};

/// Base of everything thrown on purpose. what() is the whole message: place, trouble, remedy and [cause].
class Error : public std::runtime_error {
 public:
  ExitCode exit_code() const { return exit_code_; }
  /// What is wrong: a clause, without place and full stop.
  const std::string& wrong() const { return wrong_; }
  /// What to do about it: a sentence, or empty.
  const std::string& remedy() const { return remedy_; }

 protected:
  Error(ExitCode code, const std::string& message, std::string_view wrong, std::string_view remedy);

 private:
  ExitCode exit_code_;
  std::string wrong_, remedy_;
};

/// Data that breaks a documented rule. `cause` is a stable kebab-case name listed in docs/formats.md
/// ("self-crossing", "repeated-point", ...); tests and scripts key on it.
class InputError : public Error {
 public:
  InputError(std::string_view cause, Place place, std::string_view wrong, std::string_view remedy);
  const std::string& cause() const { return cause_; }
  const Place& place() const { return place_; }

 private:
  std::string cause_;
  Place place_;
};

/// A file that cannot be opened, read, created or written.
class FileError : public Error {
 public:
  FileError(std::string_view file, std::string_view wrong, std::string_view remedy);
  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

/// A command line or call that makes no sense.
class UsageError : public Error {
 public:
  explicit UsageError(std::string_view wrong, std::string_view remedy = {});
};

/// A broken invariant of this program.
class InternalError : public Error {
 public:
  explicit InternalError(std::string_view what);
};

/// Thrown by Progress::check() after the user asked to stop. Not an error; no file is left behind.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace odontoscope
