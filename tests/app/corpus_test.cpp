// Every file of a folder, each in a process of its own.

#include <sys/stat.h>

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

class Corpus : public ProgramTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder / "in/below");
    given("in/cube.json", cube_stack());
    given("in/notes, \"odd\".txt", "nothing\n");
    given("in/below/flat.json", cube_stack("[[0,0],[1,0],[2,0]]"));
    given("in/map.nrrd", "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nencoding: text\n\n0 1 0 1 0 1 0 1\n");
    given("in/cut.nrrd", "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: raw\n\n0");
    ASSERT_EQ(::mkfifo((folder / "in/pipe").c_str(), 0600), 0);  // left out: nobody writes to it
    std::filesystem::create_directory_symlink("..", folder / "in/round");
  }
};

TEST_F(Corpus, IsTold) {
  const Ending ending = odontoscope({"corpus", "in", "-o", "table.csv", "-o", "table.md"});
  EXPECT_EQ(ending.exit_code, 0) << ending.out << ending.err;
  EXPECT_TRUE(ending.says("in: 5 files")) << ending.out;
  EXPECT_TRUE(ending.says("2  exit 0\n")) << ending.out;
  EXPECT_TRUE(ending.says("1  exit 3 [zero-area]")) << ending.out;
  EXPECT_TRUE(ending.says("1  exit 3 [truncated-volume]")) << ending.out;
  EXPECT_TRUE(ending.says("1  exit 3 [unknown-volume-format]")) << ending.out;
  const std::string table = bytes_of("table.csv");
  EXPECT_TRUE(
      table.starts_with("file,reader,exit,cause,seconds,mebibytes\n\"in/below/flat.json\",check,3,\"zero-area\","))
      << table;
  EXPECT_NE(table.find("\"in/map.nrrd\",contours,0,\"\","), table.npos) << table;
  EXPECT_NE(table.find("\"in/notes, \"\"odd\"\".txt\",contours,3,"), table.npos) << table;
  EXPECT_NE(bytes_of("table.md").find("| in/cube.json | check | 0 |  | "), table.npos) << bytes_of("table.md");
}

TEST_F(Corpus, WithAHangIsFoundWanting) {
  const Ending ending = odontoscope({"corpus", "in", "--timeout", "0", "-o", "table.csv"});
  EXPECT_EQ(ending.exit_code, 1) << ending.out << ending.err;
  EXPECT_TRUE(ending.says("ended in hang: check in/cube.json")) << ending.out;
  EXPECT_NE(bytes_of("table.csv").find("\"in/cube.json\",check,hang,"), std::string::npos);
}

TEST_F(Corpus, WithoutMemoryToStartInIsFoundWanting) {
  const Ending ending = odontoscope({"corpus", "in", "--memory", "1"});
  EXPECT_EQ(ending.exit_code, 1) << ending.out << ending.err;
}

TEST_F(Corpus, OfNoFolderIsRefused) {
  EXPECT_EQ(odontoscope({"corpus", "in/cube.json"}).exit_code, 4);
  EXPECT_EQ(odontoscope({"corpus", "in", "-o", "table.txt"}).exit_code, 2);
}

}  // namespace
}  // namespace odontoscope::testing_support
