#pragma once
// Programs of others, run in a shell.

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace odontoscope::testing_support {

struct Said {
  std::string words;   // both outputs
  int exit_code = -1;  // -1: it did not end by itself
};

inline Said run(const std::string& command) {
  Said said;
  std::FILE* pipe = ::popen(("{ " + command + "; } 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) return said;
  char buffer[4096];
  for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof(buffer), pipe)) > 0;)
    said.words.append(buffer, count);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) said.exit_code = WEXITSTATUS(status);
  return said;
}

}  // namespace odontoscope::testing_support
