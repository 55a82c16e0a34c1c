// What only one kind of operating system has is asked for in two files, so that a program for another has two to write.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Headers of POSIX and Linux, and what they add to those of the language.
std::vector<std::string> asked_of_the_system(const std::string& text) {
  static const std::regex header(
      "#include <((sys|net|netinet|arpa|linux)/[a-z_/]+\\.h|(unistd|fcntl|poll|signal|spawn|pthread|dlfcn|glob|dirent|"
      "termios|pwd|grp|sched|semaphore|fnmatch|wordexp|regex|libgen|strings|execinfo|syslog|ftw|langinfo)\\.h)>");
  static const std::regex call(
      "(^|[^A-Za-z0-9_:.>])(::)?(setenv|unsetenv|mkdtemp|mkstemp|mkostemp|fdopen|fileno|popen|pclose|localtime_r|"
      "gmtime_r|isatty|"
      "getpid|realpath|strerror_r|posix_memalign|waitpid)\\s*\\(");
  std::vector<std::string> found;
  for (const auto& [pattern, group] : {std::pair{&header, 1}, std::pair{&call, 3}})
    for (std::sregex_iterator at(text.begin(), text.end(), *pattern), end; at != end; ++at)
      found.push_back((*at)[static_cast<std::size_t>(group)]);
  return found;
}

TEST(OperatingSystem, IsAskedInTwoFilesAlone) {
  const fs::path root = ODONTOSCOPE_SOURCE;
  const std::set<std::string> two{"recon/core/posix_files.cpp", "recon/core/posix_processes.cpp"};
  std::set<std::string> asking;
  for (const char* const folder : {"recon", "engine", "python"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path ending = entry.path().extension();
      if (ending != ".h" && ending != ".cpp") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(file), {}},
          name = fs::relative(entry.path(), root).string();
      const auto found = asked_of_the_system(text);
      if (!found.empty()) asking.insert(name);
      if (!two.contains(name)) EXPECT_EQ(found, std::vector<std::string>{}) << name;
    }
  }
  EXPECT_EQ(asking, two);
}

TEST(OperatingSystem, IsFoundByHeaderAndByCall) {
  EXPECT_EQ(asked_of_the_system("#include <sys/stat.h>\n#include <poll.h>\n#include <vector>\n"),
            (std::vector<std::string>{"sys/stat.h", "poll.h"}));
  EXPECT_EQ(asked_of_the_system("  setenv(\"A\", \"b\", 0);\n  ::getpid ();\n system::setenv(1); profileno(2);"),
            (std::vector<std::string>{"setenv", "getpid"}));
}

}  // namespace
