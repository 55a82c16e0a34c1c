// Opening a file by choosing it: the folder's files that can be opened, and those that were opened before.

#include "engine/viewer/open/file_list.h"

#include <sys/stat.h>

#include <fstream>

#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

void put(const std::filesystem::path& file) { std::ofstream(file) << "x"; }

TEST(FileList, HasFoldersThenWhatCanBeOpened) {
  const ScratchFolder scratch;
  for (const char* name : {"b.GLB", "a.tour.json", "notes.txt", ".hidden.json", "scan.nii.gz"})
    put(scratch.path() / name);
  std::filesystem::create_directory(scratch.path() / "teeth");
  const FolderList list = list_folder(scratch.path());
  EXPECT_EQ(list.entries, (std::vector<FolderEntry>{{"teeth", true}, {"a.tour.json"}, {"b.GLB"}, {"scan.nii.gz"}}));
  EXPECT_TRUE(list.trouble.empty());
  EXPECT_FALSE(list_folder("/no/such/folder").trouble.empty());
  EXPECT_EQ(list_folder(scratch.path() / "teeth/").folder, scratch.path() / "teeth");
}

TEST(FileList, HasDicomWhateverItsName) {
  const ScratchFolder scratch;
  for (const char* name : {"IM0001", "1.2.840.9", "DICOMDIR"})
    std::ofstream(scratch.path() / name) << std::string(128, '\0') << "DICM and more";
  put(scratch.path() / "README");
  ASSERT_EQ(::mkfifo((scratch.path() / "pipe").c_str(), 0600), 0);  // to be left alone: nobody writes to it
  EXPECT_EQ(list_folder(scratch.path()).entries, (std::vector<FolderEntry>{{"1.2.840.9"}, {"DICOMDIR"}, {"IM0001"}}));
}

TEST(FileList, ListsNoMoreThanCanBeRead) {
  const ScratchFolder scratch;
  for (std::size_t i = 0; i < most_listed + 3; ++i) put(scratch.path() / (std::to_string(i) + ".json"));
  const FolderList list = list_folder(scratch.path());
  EXPECT_EQ(list.entries.size(), most_listed);
  EXPECT_EQ(list.left_out, 3u);
}

TEST(RecentFiles, AreTheLatestOnceEach) {
  Settings settings;
  for (const char* file : {"/a.json", "/b.json", "/a.json"}) remember_file(settings, file);
  EXPECT_EQ(settings.recent, (std::vector<std::string>{"/a.json", "/b.json"}));
  for (int i = 0; i < 20; ++i) remember_file(settings, "/" + std::to_string(i) + ".json");
  EXPECT_EQ(settings.recent.size(), most_recent_files);
  EXPECT_EQ(settings.recent.front(), "/19.json");
}

class OpeningAFile : public ViewerTest {};

TEST_F(OpeningAFile, IsAClickOnItsNameAndIsRemembered) {
  const ScratchFolder scratch;
  put(scratch.path() / "mine.json");
  std::vector<std::string> loaded;
  viewer_with_tooth({.load = [&loaded](const LoadRequest& request, const Progress&) {
    loaded.push_back(request.file);
    return toy_tooth();
  }});
  viewer().state().settings.recent = {(scratch.path() / "gone.json").string()};  // where one was last
  press_key(Key::o, {.control = true});
  frames(3);
  ASSERT_TRUE(mode<OpenMode>().file_asked_for());
  EXPECT_EQ(mode<OpenMode>().folder().folder, scratch.path());
  keep_picture("open-dialog");
  const auto entry = std::find_if(
      viewer().interface().places.begin(), viewer().interface().places.end(), [&](const Interface::Place& place) {
        return place.bottom - place.top > 10 && place.window != control_id("", {}, "open") &&
               place.window != control_id("", {}, "panel");
      });
  ASSERT_NE(entry, viewer().interface().places.end()) << "the folder's own list";
  const auto last = std::find_if(viewer().interface().places.rbegin(), viewer().interface().places.rend(),
                                 [&](const Interface::Place& place) { return place.window == entry->window; });
  click(0.5 * (last->left + last->right), 0.5 * (last->top + last->bottom));
  wait_until_loaded();
  EXPECT_EQ(loaded.back(), (scratch.path() / "mine.json").string());
  EXPECT_EQ(viewer().state().settings.recent.front(), (scratch.path() / "mine.json").string());
}

}  // namespace
}  // namespace odontoscope::testing_support
