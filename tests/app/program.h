#pragma once
// Runs odontoscope as a process in a folder of its own.

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/output/temporary_folder.h"

namespace odontoscope::testing_support {

struct Ending {
  int exit_code = -1;  // -1 if a signal ended it
  int signal = 0;
  std::string out, err;

  bool says(const std::string& words) const { return out.find(words) != std::string::npos; }
  bool complains(const std::string& words) const { return err.find(words) != std::string::npos; }
};

struct Call {
  std::vector<std::string> arguments;
  std::string folder = ".";
  /// Where standard output goes instead of Ending::out, and standard error instead of Ending::err.
  std::string out_to = {}, err_to = {};
  /// Set for it; an empty value unsets.
  std::vector<std::pair<std::string, std::string>> environment = {};
  /// Sent once the program has said something on standard error (it is at work then), and again after each pause.
  std::vector<int> signals = {};
  /// The first one after a pause instead, for a program that waits in silence.
  bool says_nothing = false;
  std::chrono::milliseconds pause{200};
};

/// Runs it to its end. Fails the test if it takes more than a minute.
Ending run(const Call& call);

/// Each test has its own folder, which is where the program runs.
class ProgramTest : public ::testing::Test {
 protected:
  Ending odontoscope(std::vector<std::string> arguments) {
    return run({.arguments = std::move(arguments), .folder = folder.path().string()});
  }
  /// Puts `text` into the test's folder as `name`.
  void given(const std::string& name, const std::string& text) { put(folder / name, text); }
  std::string bytes_of(const std::string& name) const { return content(folder / name); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }

  TemporaryFolder folder;
};

/// A contour stack file: a cube of side 1, or one with `points` in its second slice instead.
std::string cube_stack(const std::string& points = "[[0,0],[1,0],[1,1],[0,1]]");

}  // namespace odontoscope::testing_support
