#include "engine/viewer/open/open_mode.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "engine/ui/dialog.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/open/volume_dialog.h"
#include "engine/viewer/trouble.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

std::optional<GreyPicture> OpenMode::slice() const {
  if (!question_) return std::nullopt;
  const SlicePicture& drawn = question_->drawn.picture;
  return GreyPicture{drawn.width, drawn.height, drawn.grey};
}

bool OpenMode::perform(Action action) {
  if (action != Action::open_file) return false;
  const std::vector<std::string>& recent = state_.settings.recent;
  file_ = "";
  folder_ = list_folder(recent.empty() ? std::filesystem::path() : std::filesystem::path(recent.front()).parent_path());
  if (!folder_.trouble.empty()) folder_ = list_folder({});
  return true;
}

bool OpenMode::handle(const Event& event) {
  const auto* drop = std::get_if<FilesDropped>(&event);
  if (!drop) return false;
  if (!drop->files.empty()) state_.to_load = LoadRequest{.file = drop->files.front(), .volume = {}};
  if (drop->files.size() > 1) notice("One file at a time: the first was taken.");
  return true;
}

/// A volume: where does its surface lie? What helps to answer is read meanwhile.
bool OpenMode::takes_request(LoadRequest& request) {
  if (!at_.options.wants_level(request)) return false;
  question_ = VolumeQuestion{.request = std::move(request)};
  if (preview_) stop_preview();
  if (!at_.options.preview) return true;
  question_->reading = true;
  preview_ = std::make_unique<Job<VolumePreview>>([preview = at_.options.preview, asked = question_->request](
                                                      const Progress& progress) { return preview(asked, progress); });
  return true;
}

void OpenMode::stop_preview() {
  preview_->cancel();
  stopped_.push_back(std::move(preview_));
}

void OpenMode::update() {
  std::erase_if(stopped_, [](const auto& job) { return job->finished(); });
  if (!preview_) return;
  if (!question_) return stop_preview();  // answered or called off before there was anything to see
  question_->read = preview_->stage().fraction;
  if (!preview_->finished()) return;
  const auto job = std::move(preview_);
  try {
    take_preview(*question_, job->take());
    at_.frames_to_settle = 3;
  } catch (...) {
    question_.reset();
    state_.failure = std::current_exception();
    state_.trouble = words_for_current_exception();
  }
}

bool OpenMode::put_away(PutAway what) {
  if (what != PutAway::dialog || !dialog_open()) return false;
  if (question_)
    question_.reset();
  else
    file_.reset();
  return true;
}

bool OpenMode::answer() {
  if (!question_) return false;
  if (!question_->answered()) return true;
  state_.to_load = answer_of(*question_);
  question_.reset();
  return true;
}

bool OpenMode::draw_dialog() {
  if (question_)
    question_dialog();
  else if (file_)
    file_dialog();
  else
    return false;
  return true;
}

void OpenMode::question_dialog() {
  const float with_picture = 760, with_series = 560, alone = 460;
  const Dialog dialog("question", at_.layout.viewport,
                      question_->preview          ? with_picture
                      : question_->series.empty() ? alone
                                                  : with_series);
  dialog_title(at_.interface, name_of(question_->request.file).c_str());
  VolumeAnswer answer = volume_dialog(*question_, at_.interface);
  if (answer.open) state_.to_load = std::move(answer.open);
  if (answer.put_away) question_.reset();
}

/// Recent files, and the folder to go through; the file that was pressed, or nothing.
std::string OpenMode::listed_file() {
  std::string chosen;
  const auto row = [&](const std::string& words, const std::string& file) {
    if (widgets::wide_button(words.c_str())) chosen = file;
  };
  const std::vector<std::string>& recent = state_.settings.recent;
  if (!recent.empty()) widgets::remark(at_.interface, "Opened before");
  constexpr std::size_t most_shown = 4;
  for (std::size_t i = 0; i < std::min(recent.size(), most_shown); ++i) {
    const std::filesystem::path file(recent[i]);
    ImGui::PushID(static_cast<int>(i));
    row(fmt::format("{}   in {}", file.filename().string(), file.parent_path().filename().string()), file.string());
    ImGui::PopID();
  }
  widgets::remark(at_.interface, folder_.folder.string());
  if (!folder_.trouble.empty()) widgets::remark(at_.interface, folder_.trouble);
  ImGui::BeginChild("folder", {0, widgets::scaled(190)});
  std::filesystem::path enter;
  if (folder_.folder.has_parent_path() && folder_.folder != folder_.folder.root_path() && widgets::wide_button(".."))
    enter = folder_.folder.parent_path();
  for (const FolderEntry& entry : folder_.entries) {
    ImGui::PushID(entry.name.c_str());
    if (entry.folder) {
      if (widgets::wide_button((entry.name + "/").c_str())) enter = folder_.folder / entry.name;
    } else {
      row(entry.name, (folder_.folder / entry.name).string());
    }
    ImGui::PopID();
  }
  if (folder_.left_out > 0)
    widgets::remark(at_.interface, fmt::format("{} more are not listed: type the name.", folder_.left_out));
  ImGui::EndChild();
  if (!enter.empty()) folder_ = list_folder(enter);
  return chosen;
}

void OpenMode::file_dialog() {
  const Dialog dialog("open", at_.layout.viewport, 560);
  dialog_title(at_.interface, "Open a file");
  widgets::remark(at_.interface,
                  "A contour stack, a GLB, STL or PLY mesh, a volume, or a lesson. Dropping it on the window does the "
                  "same. Nothing typed: the sample molar.");
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  widgets::text_field("##file");
  bool open = ImGui::InputText("##file", &*file_, ImGuiInputTextFlags_EnterReturnsTrue);
  widgets::noted("##file");
  if (const std::string chosen = listed_file(); !chosen.empty()) {
    file_ = chosen;
    open = true;
  }
  open = widgets::wide_button("Open", true) || open;
  if (open) {
    state_.to_load = LoadRequest{.file = *file_, .volume = {}};
    file_.reset();
    return;
  }
  if (widgets::wide_button("Cancel")) file_.reset();
}

}  // namespace odontoscope
