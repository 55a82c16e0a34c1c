#pragma once
// What is to be opened: files dropped on the window, a file to choose, and the question that a volume raises.

#include <memory>
#include <optional>
#include <string>
#include <vector>

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

  bool takes_request(LoadRequest& request) override;
  bool perform(Action action) override;
  bool handle(const Event& event) override;
  bool put_away(PutAway what) override;
  bool answer() override;
  bool dialog_open() const override { return question_ || file_; }
  void update() override;
  bool working() const override { return preview_ != nullptr; }
  std::optional<GreyPicture> slice() const override;
  bool draw_dialog() override;

 private:
  void stop_preview();
  void question_dialog();
  void file_dialog();
  std::string listed_file();

  std::optional<VolumeQuestion> question_;
  std::unique_ptr<Job<VolumePreview>> preview_;
  std::vector<std::unique_ptr<Job<VolumePreview>>> stopped_;  // until they have noticed
  std::optional<std::string> file_;
  FolderList folder_;  // that is shown beside
};

}  // namespace odontoscope
