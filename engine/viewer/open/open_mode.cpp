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
#include "recon/core/error.h"

namespace odontoscope {

std::optional<GreyPicture> OpenMode::slice() const {
  if (!question_) return std::nullopt;
  const SlicePicture& drawn = question_->drawn.picture;
  return GreyPicture{drawn.width, drawn.height, drawn.grey};
}

bool OpenMode::perform(Action action) {
  if (action == Action::open_file)
    ask(FileQuestion::For::opening);
  else if (action == Action::choose_save_folder)
    ask(FileQuestion::For::folder);
  else
    return false;
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

void OpenMode::ask(FileQuestion::For what) {
  if (dialog_open()) return;  // a key that is held repeats
  asked_for_ = what;
  const std::vector<std::string>& recent = state_.settings.recent;
  const std::filesystem::path last = what == FileQuestion::For::folder ? at_.files.folder()
                                     : recent.empty()                  ? std::filesystem::path()
                                                      : std::filesystem::path(recent.front()).parent_path();
  folder_ = list_folder(last);
  if (!folder_.trouble.empty()) folder_ = list_folder({});
  if (state_.settings.desktop_dialogs && !at_.options.dialog_program.empty())
    ask_the_desktop();
  else
    ask_by_list();
}

const char* OpenMode::title() const {
  return asked_for_ == FileQuestion::For::folder ? "A folder to save in" : "Open a file";
}

void OpenMode::ask_the_desktop() {
  try {
    desktop_ = std::make_unique<DesktopDialog>(at_.options.dialog_program,
                                               FileQuestion{asked_for_, at_.interface.say(title()), folder_.folder});
  } catch (const Error& error) {
    notice(error.what(), NoticeKind::bad);
    ask_by_list();
  }
}

void OpenMode::ask_by_list() {
  desktop_.reset();
  file_ = "";
}

/// What the desktop's dialog came to; where it has trouble, the list here goes on.
void OpenMode::take_answer() {
  const std::optional<FileAnswer> answer = desktop_->answer();
  if (!answer) return;
  desktop_.reset();
  at_.frames_to_settle = 3;
  if (!answer->trouble.empty()) {
    notice(answer->trouble, NoticeKind::bad);
    ask_by_list();
  } else if (!answer->file.empty()) {
    take_file(answer->file);
  }
}

/// Chosen, or nothing typed: the sample molar.
void OpenMode::take_file(const std::filesystem::path& file) {
  file_.reset();
  if (asked_for_ == FileQuestion::For::opening) {
    state_.to_load = LoadRequest{.file = file.string(), .volume = {}};
    return;
  }
  at_.files.move_to(file);
  state_.settings.save_folder = file.string();
  notice(fmt::format("Files are saved in {}", file.string()));
}

void OpenMode::stop_preview() {
  preview_->cancel();
  stopped_.push_back(std::move(preview_));
}

void OpenMode::update() {
  std::erase_if(stopped_, [](const auto& job) { return job->finished(); });
  if (desktop_) take_answer();
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
  if (question_) {
    question_.reset();
  } else {
    file_.reset();
    desktop_.reset();
  }
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
  else if (desktop_)
    desktop_dialog();
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

/// The window stays alive below; a dialog that hangs, or lies behind it, is left for the list.
void OpenMode::desktop_dialog() {
  const Dialog dialog("desktop", at_.layout.viewport, 460);
  dialog_title(at_.interface, title());
  widgets::remark(at_.interface, "The desktop asks, in a window of its own.");
  if (widgets::wide_button("Choose from a list here")) return ask_by_list();
  if (widgets::wide_button("Always from the list here")) {
    state_.settings.desktop_dialogs = false;
    return ask_by_list();
  }
  if (widgets::wide_button("Cancel")) desktop_.reset();
}

/// Files that were opened before, or the folders that they lie in; the one that was pressed, or nothing.
std::string OpenMode::recent_rows() {
  constexpr std::size_t most_shown = 4;
  std::string chosen;
  std::vector<std::filesystem::path> shown;
  for (const std::string& recent : state_.settings.recent) {
    const std::filesystem::path file(recent), one = asked_for_ == FileQuestion::For::folder ? file.parent_path() : file;
    if (shown.size() < most_shown && std::find(shown.begin(), shown.end(), one) == shown.end()) shown.push_back(one);
  }
  if (!shown.empty()) widgets::remark(at_.interface, "Opened before");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const std::string words =
        fmt::format("{}   in {}", shown[i].filename().string(), shown[i].parent_path().filename().string());
    if (widgets::wide_button(words.c_str())) chosen = shown[i].string();
    ImGui::PopID();
  }
  return chosen;
}

/// What was there before, and the folder to go through; the file that was pressed, or nothing.
std::string OpenMode::listed_file() {
  const bool folders_alone = asked_for_ == FileQuestion::For::folder;
  std::string chosen = recent_rows();
  std::filesystem::path enter;
  if (folders_alone) enter = std::exchange(chosen, {});
  widgets::remark(at_.interface, folder_.folder.string());
  if (!folder_.trouble.empty()) widgets::remark(at_.interface, folder_.trouble);
  ImGui::BeginChild("folder", {0, widgets::scaled(190)});
  if (folder_.folder.has_parent_path() && folder_.folder != folder_.folder.root_path() && widgets::wide_button(".."))
    enter = folder_.folder.parent_path();
  for (const FolderEntry& entry : folder_.entries) {
    if (folders_alone && !entry.folder) continue;
    ImGui::PushID(entry.name.c_str());
    if (entry.folder) {
      if (widgets::wide_button((entry.name + "/").c_str())) enter = folder_.folder / entry.name;
    } else if (widgets::wide_button(entry.name.c_str())) {
      chosen = (folder_.folder / entry.name).string();
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
  const bool folder = asked_for_ == FileQuestion::For::folder;
  const Dialog dialog("open", at_.layout.viewport, 560);
  dialog_title(at_.interface, title());
  widgets::remark(at_.interface,
                  folder ? "Pictures, scenes and lessons go there. Type a folder, or go to it below."
                         : "A contour stack, a GLB, STL or PLY mesh, a volume, or a lesson. Dropping it on the window "
                           "does the same. Nothing typed: the sample molar.");
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  widgets::text_field("##file");
  bool done = ImGui::InputText("##file", &*file_, ImGuiInputTextFlags_EnterReturnsTrue);
  widgets::noted("##file");
  if (const std::string chosen = listed_file(); !chosen.empty()) {
    file_ = chosen;
    done = true;
  }
  done = widgets::wide_button(folder ? "Save in this folder" : "Open", widgets::Emphasis::strong) || done;
  if (!at_.options.dialog_program.empty())
    widgets::toggle("Ask in the desktop's dialog", state_.settings.desktop_dialogs);
  const bool called_off = widgets::wide_button("Cancel");
  if (done)
    take_typed();
  else if (called_off)
    file_.reset();
}

/// What was typed or pressed; of a folder nothing typed means the one that is listed.
void OpenMode::take_typed() {
  if (asked_for_ == FileQuestion::For::opening) return take_file(*file_);
  std::error_code error;
  const std::filesystem::path folder = file_->empty() ? folder_.folder : std::filesystem::absolute(*file_, error);
  if (std::filesystem::is_directory(folder, error))
    take_file(folder);
  else
    notice(fmt::format("There is no folder {}", folder.string()), NoticeKind::bad);
}

}  // namespace odontoscope
