// The desktop's dialogs, by programs that stand in for zenity: one that answers, that hangs, that talks nonsense.

#include "engine/view/desktop_dialog.h"

#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "engine/viewer/open/open_mode.h"
#include "recon/core/error.h"
#include "tests/ui/driver.h"

namespace odontoscope::testing_support {
namespace {

/// A program of these lines.
std::string program(const ScratchFolder& scratch, const std::string& lines, const std::string& name = "stand-in") {
  const std::filesystem::path file = scratch.path() / name;
  std::ofstream(file) << "#!/bin/sh\n" << lines << "\n";
  ::chmod(file.c_str(), 0700);
  return file.string();
}

FileAnswer answer_of(DesktopDialog& dialog) {
  for (int i = 0; i < 4000; ++i) {
    if (const auto answer = dialog.answer()) return *answer;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return {{}, "it never answered"};
}

FileAnswer asked(const std::string& program, FileQuestion::For what = FileQuestion::For::opening,
                 const std::filesystem::path& at = "/") {
  DesktopDialog dialog(program, {what, "Open a file", at});
  return answer_of(dialog);
}

TEST(DesktopDialog, TellsTheFileThatWasChosen) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "a tooth.json") << "x";
  const std::string chosen = (scratch.path() / "a tooth.json").string();
  const std::string stand_in =
      program(scratch, "printf '%s\\n' \"$@\" > '" + (scratch.path() / "words").string() + "'; echo '" + chosen + "'");
  const FileAnswer answer = asked(stand_in, FileQuestion::For::opening, scratch.path());
  EXPECT_EQ(answer.trouble, "");
  EXPECT_EQ(answer.file, chosen);
  std::ifstream words(scratch.path() / "words");
  const std::string said((std::istreambuf_iterator<char>(words)), {});
  EXPECT_EQ(said, "--file-selection\n--title=Open a file\n--filename=" + scratch.path().string() + "/\n");
}

TEST(DesktopDialog, SpeaksKdialogToo) {
  const ScratchFolder scratch;
  const std::string stand_in = program(scratch, "test \"$3\" = --getexistingdirectory && echo \"$4\"", "kdialog");
  EXPECT_EQ(asked(stand_in, FileQuestion::For::folder, scratch.path()).file, scratch.path());
}

TEST(DesktopDialog, CalledOffIsNoTrouble) {
  const ScratchFolder scratch;
  const FileAnswer answer = asked(program(scratch, "exit 1"));
  EXPECT_TRUE(answer.file.empty());
  EXPECT_EQ(answer.trouble, "");
}

TEST(DesktopDialog, NonsenseIsToldAndTakenForNothing) {
  const ScratchFolder scratch;
  for (const char* lines :
       {"echo", "echo relative.json", "printf '/tmp\\n/usr\\n'", "printf '/\\001'", "true",
        "echo /no/such/file/anywhere", "head -c 100000 /dev/zero", "yes", "echo /tmp; exit 3", "kill -9 $$"}) {
    const FileAnswer answer = asked(program(scratch, lines));
    EXPECT_TRUE(answer.file.empty()) << lines;
    EXPECT_NE(answer.trouble, "") << lines;
    EXPECT_NE(answer.trouble, "it never answered") << lines;
  }
  EXPECT_NE(asked(program(scratch, "echo no display >&2; exit 5")).trouble.find("no display"), std::string::npos);
  EXPECT_NE(asked(program(scratch, "echo /bin/sh"), FileQuestion::For::folder).trouble, "") << "a file is no folder";
}

TEST(DesktopDialog, ThatIsNotThereIsAnError) { EXPECT_THROW(DesktopDialog("/no/such/program", {}), FileError); }

TEST(DesktopDialog, ThatHangsEndsWithItsOwner) {
  const ScratchFolder scratch;
  const std::filesystem::path mark = scratch.path() / "number";
  const std::string stand_in = program(scratch, "echo $$ > '" + mark.string() + "'; exec sleep 600");
  const auto before = std::chrono::steady_clock::now();
  std::string number;
  {
    DesktopDialog dialog(stand_in, {});
    while (number.empty()) {
      EXPECT_FALSE(dialog.answer());
      std::getline(std::ifstream(mark) >> std::ws, number);
    }
  }
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(60));
  EXPECT_NE(::kill(std::stoi(number), 0), 0) << "it still runs";
}

class DesktopDialogInViewer : public ViewerTest {
 protected:
  void viewer_with_dialog(const std::string& program) {
    ViewerOptions options;
    options.load = [this](const LoadRequest& request, const Progress&) {
      loaded_.push_back(request.file);
      return toy_tooth();
    };
    options.dialog_program = program;
    viewer_with_tooth(std::move(options));
  }
  /// Frames go on until the program is done.
  void until_answered() {
    for (int i = 0; i < 2000 && mode<OpenMode>().desktop_asks(); ++i) {
      frames(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  ScratchFolder scratch_;
  std::vector<std::string> loaded_;
};

TEST_F(DesktopDialogInViewer, OpensWhatWasChosen) {
  std::ofstream(scratch_.path() / "mine.json") << "x";
  viewer_with_dialog(program(scratch_, "sleep 0.2; echo '" + (scratch_.path() / "mine.json").string() + "'"));
  press_key(Key::o, {.control = true});
  frames(3);
  EXPECT_TRUE(mode<OpenMode>().desktop_asks());
  EXPECT_FALSE(mode<OpenMode>().file_asked_for());
  keep_picture("desktop-dialog");
  until_answered();
  wait_until_loaded();
  EXPECT_EQ(loaded_.back(), (scratch_.path() / "mine.json").string());
}

TEST_F(DesktopDialogInViewer, ThatHangsIsLeftByEscapeAndOneThatFailsForTheList) {
  viewer_with_dialog(program(scratch_, "sleep 600"));
  press_key(Key::o, {.control = true});
  frames(30);  // the window goes on
  EXPECT_TRUE(mode<OpenMode>().desktop_asks());
  press_key(Key::escape);
  frames(2);
  EXPECT_FALSE(mode<OpenMode>().dialog_open());
  program(scratch_, "echo out of order >&2; exit 7");
  press_key(Key::o, {.control = true});
  frames(1);
  until_answered();
  frames(2);
  EXPECT_TRUE(mode<OpenMode>().file_asked_for()) << "the list stands in";
  ASSERT_FALSE(viewer().state().notices.empty());
  EXPECT_NE(viewer().state().notices.back().words.find("out of order"), std::string::npos);
  press_key(Key::escape);
  frames(2);
  viewer().state().settings.desktop_dialogs = false;  // by choice
  press_key(Key::o, {.control = true});
  frames(2);
  EXPECT_FALSE(mode<OpenMode>().desktop_asks());
  EXPECT_TRUE(mode<OpenMode>().file_asked_for());
}

TEST_F(DesktopDialogInViewer, ChoosesWhereToSave) {
  const std::filesystem::path there = scratch_.path() / "pictures";
  std::filesystem::create_directory(there);
  viewer_with_dialog(program(scratch_, "test \"$4\" = --directory && echo '" + there.string() + "'"));
  viewer().state().pending_actions.push_back(Action::choose_save_folder);
  frames(1);
  until_answered();
  EXPECT_EQ(viewer().state().settings.save_folder, there.string());
  press_key(Key::s, {.control = true});
  frames(3);
  EXPECT_FALSE(std::filesystem::is_empty(there));
}

TEST_F(DesktopDialogInViewer, TheListChoosesAFolderAsWell) {
  const std::filesystem::path there = scratch_.path() / "scenes";
  std::filesystem::create_directory(there);
  viewer_with_dialog("");
  viewer().state().settings.recent = {(there / "gone.json").string()};
  viewer().state().pending_actions.push_back(Action::choose_save_folder);
  frames(3);
  ASSERT_TRUE(mode<OpenMode>().file_asked_for());
  keep_picture("folder-dialog");
  for (const char c : there.string()) type(static_cast<char32_t>(c));
  press_key(Key::enter);
  frames(3);
  EXPECT_FALSE(mode<OpenMode>().dialog_open());
  EXPECT_EQ(viewer().state().settings.save_folder, there.string());
}

}  // namespace
}  // namespace odontoscope::testing_support
