// Data flows one way through the house: what a room includes, it links; what it links, comes before it; geometry never
// sees GL.
#include "tests/house/rooms.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace odontoscope::test {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::filesystem::path source = ODONTOSCOPE_SOURCE;

std::vector<Room> declared_rooms() { return read_rooms(text_of(ODONTOSCOPE_ROOM_LINKS)); }

std::string listed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(Rooms, LinkOnlyToRoomsBeforeThem) {
  const auto rooms = declared_rooms();
  ASSERT_GT(rooms.size(), 20U);
  EXPECT_EQ(listed(faults_of_links(rooms)), "");
}

TEST(Rooms, IncludeOnlyFromRoomsThatTheyLink) { EXPECT_EQ(listed(faults_of_tree(declared_rooms(), source)), ""); }

TEST(Rooms, AreDrawnInTheDocumentationAsTheyAre) {
  const std::string page = text_of(source / "docs/architecture.md");
  const std::string picture = picture_of(declared_rooms());
  EXPECT_NE(page.find("```mermaid\n" + picture + "```"), std::string::npos) << "docs/architecture.md should show:\n"
                                                                            << picture;
}

TEST(Rooms, AllHaveALineInTheDocumentation) {
  const std::string page = text_of(source / "docs/architecture.md");
  for (const Room& room : declared_rooms())
    EXPECT_NE(page.find("| `" + room.folder + "` |"), std::string::npos) << room.folder;
}

// What the tests above would say.
const std::vector<Room> three{{"recon/core", {}}, {"recon/mesh", {"core"}}, {"engine/gpu", {"core"}}};

TEST(RoomsJudged, AnIncludeUpwardsIsFound) {
  EXPECT_EQ(listed(faults_of_includes(three, three[1], "#include <vector>\n#include \"engine/gpu/gl.h\"\n")),
            "line 2: engine/gpu/gl.h\n");
  EXPECT_EQ(listed(faults_of_includes(three, three[0], "#include \"recon/mesh/weld.h\"\n")),
            "line 1: recon/mesh/weld.h\n");
}

TEST(RoomsJudged, AnIncludeOfNoRoomIsFound) {
  EXPECT_EQ(listed(faults_of_includes(three, three[1], "#include \"weld.h\"\n")), "line 1: weld.h\n");
}

TEST(RoomsJudged, ARoomsOwnAndLinkedFilesAreNoFault) {
  EXPECT_EQ(
      listed(faults_of_includes(three, three[1], "#include \"recon/mesh/weld.h\"\n#include \"recon/core/error.h\"\n")),
      "");
}

TEST(RoomsJudged, LinksUpwardsAreFound) {
  EXPECT_EQ(listed(faults_of_links({{"recon/core", {"mesh"}}, {"recon/mesh", {"core"}}})),
            "recon/core links recon/mesh, which comes after it\n");
  EXPECT_EQ(listed(faults_of_links({{"engine/gpu", {}}, {"recon/mesh", {"gpu"}}})),
            "recon/mesh links engine/gpu, which is the engine's\n");
  EXPECT_EQ(listed(faults_of_links({{"recon/core", {"cellar"}}})), "recon/core links cellar, which is no room\n");
}

}  // namespace
}  // namespace odontoscope::test
