#pragma once
// What is to be opened: files dropped on the window, a file to choose, and the question that a volume raises. Folders
// to save in are chosen alike.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/view/desktop_dialog.h"
#include "engine/viewer/mode.h"
#include "engine/viewer/open/file_list.h"
#include "engine/viewer/open/volume_question.h"

namespace odontoscope {

class OpenMode final : public Mode {
 public:
  using Mode::Mode;

  std::optional<VolumeQuestion>& question() { return question_; }
  /// That is being typed; nothing: none is asked for.
  const std::optional<std::string>& file_asked_for() const { return file_; }
  const FolderList& folder() const { return folder_; }
  bool desktop_asks() const { return desktop_ != nullptr; }

  bool takes_request(LoadRequest& request) override;
  bool perform(Action action) override;
  bool handle(const Event& event) override;
  bool put_away(PutAway what) override;
  bool answer() override;
  bool dialog_open() const override { return question_ || file_ || desktop_; }
  void update() override;
  bool working() const override { return preview_ || desktop_; }
  std::optional<GreyPicture> slice() const override;
  bool draw_dialog() override;

 private:
  void stop_preview();
  void question_dialog();
  void file_dialog();
  void desktop_dialog();
  void ask(FileQuestion::For what);
  const char* title() const;
  void ask_the_desktop();
  void ask_by_list();
  void take_answer();
  void take_typed();
  void take_file(const std::filesystem::path& file);
  std::string listed_file();
  std::string recent_rows();

  std::optional<VolumeQuestion> question_;
  std::unique_ptr<Job<VolumePreview>> preview_;
  std::vector<std::unique_ptr<Job<VolumePreview>>> stopped_;  // until they have noticed
  FileQuestion::For asked_for_ = FileQuestion::For::opening;
  std::unique_ptr<DesktopDialog> desktop_;
  std::optional<std::string> file_;
  FolderList folder_;  // that is shown beside
};

}  // namespace odontoscope
