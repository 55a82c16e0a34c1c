#include "engine/viewer/load/load_mode.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/ui/dialog.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "engine/viewer/trouble.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

using widgets::scaled;

void LoadMode::open(LoadRequest request) {
  if (job_) {
    job_->cancel();
    stopped_.push_back(std::move(job_));
  }
  state_.trouble.clear();
  state_.failure = nullptr;
  for (const auto& mode : at_.modes)
    if (mode->takes_request(request)) return;
  job_ = std::make_unique<LoadJob>(at_.options.load, request,
                                   at_.options.with_drafts && (!state_.shown || state_.origin.draft));
}

void LoadMode::update() {
  std::erase_if(stopped_, [](const auto& job) { return job->finished(); });
  if (std::exchange(cancel_asked_, false) && job_) job_->cancel();
  if (!job_) return;
  take_draft();
  if (!job_->finished()) return;
  const std::unique_ptr<LoadJob> job = std::move(job_);
  state_.failure = nullptr;
  try {
    take_model(job->request(), job->take());
  } catch (const Cancelled&) {
    give_up();
    notice("Stopped.");
  } catch (...) {
    give_up();
    state_.failure = std::current_exception();
    state_.trouble = words_for_current_exception();
  }
}

void LoadMode::take_model(const LoadRequest& request, LoadedModel loaded) {
  auto made = std::make_shared<const LoadedModel>(std::move(loaded));
  // Who turned the draft goes on from there.
  const std::optional<Camera> turned =
      state_.origin.draft && draft_camera_ && !made->given.camera && state_.scene.camera != *draft_camera_
          ? std::optional(state_.scene.camera)
          : std::nullopt;
  at_.show(std::move(made));
  if (turned) state_.scene.camera = *turned;
  state_.origin.sample = request.file.empty();
  // As if it were opened by its name alone: of a volume that would be asked about.
  const bool by_name = !request.volume && !at_.options.wants_level({.file = request.file, .volume = {}});
  state_.origin.file = by_name ? request.file : std::string();
  if (!request.file.empty()) remember_file(state_.settings, request.file);
  for (const auto& mode : at_.modes) mode->loaded(request);
}

void LoadMode::give_up() {
  for (const auto& mode : at_.modes) mode->load_failed();
  if (!std::exchange(state_.origin.draft, false)) return;
  for (const auto& mode : at_.modes) mode->leave();
  state_.shown.reset();  // it stood for a model that will not be
}

void LoadMode::take_draft() {
  if (job_->finished() || job_->cancelling() || (state_.shown && !state_.origin.draft)) return;
  if (auto draft = job_->take_draft()) {
    at_.show(std::move(draft));
    state_.origin.draft = true;
    draft_camera_ = state_.scene.camera;
  }
}

bool LoadMode::put_away(PutAway what) {
  if (what != PutAway::dialog || (!job_ && state_.trouble.empty())) return false;
  if (job_)
    job_->cancel();
  else
    state_.trouble.clear();
  return true;
}

bool LoadMode::answer() {
  if (state_.trouble.empty()) return false;
  state_.trouble.clear();
  return true;
}

bool LoadMode::draw_dialog() {
  if (job_)
    loading_dialog();
  else if (!state_.trouble.empty())
    trouble_dialog();
  else
    return false;
  return true;
}

void LoadMode::loading_dialog() {
  const Area& viewport = at_.layout.viewport;
  // Below a draft, which is to be seen.
  const double strip = std::min<double>(scaled(190), viewport.height);
  const Dialog dialog("loading",
                      state_.origin.draft
                          ? Area{viewport.left, viewport.top + viewport.height - strip, viewport.width, strip}
                          : viewport,
                      400);
  dialog_title(at_.interface, fmt::format("Making {}", name_of(job_->request().file)).c_str());
  const LoadJob::Stage stage = job_->stage();
  widgets::remark(at_.interface, job_->cancelling() ? "Stopping\xE2\x80\xA6" : stage_in_words(stage.name));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = scaled(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme::raised, height / 2);
  const float done = static_cast<float>(std::clamp(stage.fraction, 0.02, 1.0));
  list.AddRectFilled(corner, {corner.x + done * width, corner.y + height}, theme::accent, height / 2);
  ImGui::Dummy({width, height + scaled(6)});
  if (widgets::wide_button("Cancel")) cancel_asked_ = true;
}

void LoadMode::trouble_dialog() {
  const Dialog dialog("trouble", at_.layout.viewport, 520);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::bad);
  dialog_title(at_.interface, "That did not work");
  ImGui::PopStyleColor();
  draw_trouble(at_.interface, state_.trouble);
  ImGui::Dummy({0, scaled(2)});
  if (widgets::wide_button("Close")) state_.trouble.clear();
}

std::string stage_in_words(std::string_view stage) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 13> known = {
      {{"read", "Reading the file"},
       {"contours", "Tracing contours through the volume"},
       {"simplify", "Leaving out points that say nothing"},
       {"validate", "Checking the contours"},
       {"conform", "Triangulating the slices"},
       {"slabs", "Joining neighbouring slices"},
       {"plates", "Closing what ends between slices"},
       {"assemble", "Putting the slabs together"},
       {"certify", "Proving that the model is sound"},
       {"shade", "Smoothing the light"},
       {"prepare picking", "Preparing to measure"},
       {"centre lines", "Finding the canals"},
       {"wall thickness", "Measuring how thick walls are"}}};
  for (const auto& [name, words] : known)
    if (stage == name) return std::string(words);
  return stage.empty() ? "Beginning" : fmt::format("Working: {}", stage);
}

}  // namespace odontoscope
