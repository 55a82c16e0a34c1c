#include "engine/viewer/open/volume_dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/ui/interface_pass.h"
#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"

namespace odontoscope {
namespace {

using widgets::scaled;

/// As large as fits, in the shape that the slice has in millimetres, with the outline over it.
void slice_in_outline(const VolumeQuestion& question, float side) {
  const VolumePreview& preview = *question.preview;
  const SlicePicture& picture = question.drawn.picture;
  const float wide = static_cast<float>(static_cast<double>(picture.width) * preview.values.step_mm.x),
              high = static_cast<float>(static_cast<double>(picture.height) * preview.values.step_mm.y);
  const float scale = side / std::max(wide, high);
  const ImVec2 frame = ImGui::GetCursorScreenPos();
  const ImVec2 corner(frame.x + (side - scale * wide) / 2, frame.y + (side - scale * high) / 2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(frame, {frame.x + side, frame.y + side}, theme::rgb(0x000000, 255), scaled(6));
  list.AddImage(grey_picture(), corner, {corner.x + scale * wide, corner.y + scale * high});
  const float x = scale * wide / static_cast<float>(picture.width),
              y = scale * high / static_cast<float>(picture.height);
  for (const auto& [from, to] : question.drawn.outline)
    list.AddLine({corner.x + static_cast<float>(from.x) * x, corner.y + static_cast<float>(from.y) * y},
                 {corner.x + static_cast<float>(to.x) * x, corner.y + static_cast<float>(to.y) * y}, theme::accent,
                 scaled(1.5f));
  ImGui::Dummy({side, side});
}

/// Bars over the grey values; a click or drag sets the surface's.
void histogram(VolumeQuestion& question, float height) {
  const VolumePreview& preview = *question.preview;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme::raised, scaled(4));
  const double span = std::max(preview.high - preview.low, 1e-30);
  const auto at = [&](double value) {
    return corner.x + static_cast<float>(std::clamp((value - preview.low) / span, 0.0, 1.0)) * width;
  };
  const float bar = width / static_cast<float>(std::max<std::size_t>(preview.bars.size(), 1));
  for (std::size_t i = 0; i < preview.bars.size(); ++i) {
    const float left = corner.x + static_cast<float>(i) * bar;
    list.AddRectFilled({left, corner.y + height - preview.bars[i] * (height - scaled(6))},
                       {left + std::max(bar - scaled(0.5f), 1.0f), corner.y + height}, theme::quiet);
  }
  for (const double threshold : preview.thresholds)
    list.AddLine({at(threshold), corner.y}, {at(threshold), corner.y + scaled(8)}, theme::text, scaled(1.5f));
  list.AddLine({at(question.iso), corner.y}, {at(question.iso), corner.y + height}, theme::accent, scaled(2));
  ImGui::InvisibleButton("##histogram", {width, height});
  widgets::noted("##histogram", widgets::Field::drawn);
  if (!ImGui::IsItemActive()) return;
  const double share = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - corner.x) / width), 0.0, 1.0);
  question.iso = preview.low + share * span;
  question.iso_said = true;
}

void ask_for_grey_value(VolumeQuestion& question, const Interface& interface) {
  ImGui::PushTextWrapPos(0);
  widgets::text("At which grey value does the surface lie?");
  ImGui::PopTextWrapPos();
  if (question.preview) histogram(question, scaled(84));
  if (question.preview && !question.preview->thresholds.empty()) {
    widgets::remark(interface, "Between two kinds of matter, then three (Otsu):");
    for (std::size_t i = 0; i < question.preview->thresholds.size(); ++i) {
      if (i > 0) ImGui::SameLine();
      if (widgets::button(fmt::format("{:.4g}##threshold{}", question.preview->thresholds[i], i).c_str())) {
        question.iso = question.preview->thresholds[i];
        question.iso_said = true;
      }
    }
  } else {
    widgets::remark(interface,
                    "In CT, dentine begins where soft tissue and air end. Too low a value shows noise, too high a "
                    "value eats into the tooth.");
  }
  widgets::text("Grey value");
  ImGui::SetNextItemWidth(-1);
  widgets::text_field("##iso");
  question.iso_said = ImGui::InputDouble("##iso", &question.iso, 0, 0, "%.6g") || question.iso_said;
  widgets::noted("##iso");
}

void ask_for_labels(VolumeQuestion& question, const Interface& interface) {
  ImGui::PushTextWrapPos(0);
  widgets::text("It looks like a label map. Which of its labels are to be seen?");
  ImGui::PopTextWrapPos();
  widgets::remark(interface, "Each becomes a structure of its own.");
  constexpr std::size_t rows_seen = 7;
  const float row = ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("labels", {0, row * static_cast<float>(std::min(question.preview->labels.size(), rows_seen))});
  for (const VolumePreview::Label& label : question.preview->labels) {
    bool wanted = question.labels.contains(label.value);
    const std::string words =
        label.name.empty() ? fmt::format("Label {}", label.value) : fmt::format("{} ({})", label.name, label.value);
    if (!widgets::toggle(words.c_str(), wanted)) continue;
    if (wanted)
      question.labels.insert(label.value);
    else
      question.labels.erase(label.value);
  }
  ImGui::EndChild();
}

void ask(VolumeQuestion& question, const Interface& interface) {
  if (question.preview && !question.preview->labels.empty()) {
    int kind = question.as_grey ? 1 : 0;
    if (widgets::choice("kind", kind, {"Labels", "Grey values"})) question.as_grey = kind == 1;
  }
  if (question.of_labels())
    ask_for_labels(question, interface);
  else
    ask_for_grey_value(question, interface);
  widgets::text("Leave out contours smaller than, pixels");
  ImGui::SetNextItemWidth(-1);
  widgets::text_field("##area");
  ImGui::InputDouble("##area", &question.min_area_pixels, 0, 0, "%g");
  widgets::noted("##area");
  question.min_area_pixels = std::max(question.min_area_pixels, 0.0);
}

std::string size_in_words(const VolumePreview& preview) {
  return fmt::format("{} x {} x {} voxels of {:.3g} x {:.3g} x {:.3g} mm", preview.size[0], preview.size[1],
                     preview.size[2], preview.spacing_mm[0], preview.spacing_mm[1], preview.spacing_mm[2]);
}

std::string size_in_words(const SeriesOffer& offer) {
  if (!offer.trouble.empty()) return fmt::format("It cannot be read ({}).", offer.trouble);
  if (!offer.segments.empty()) return fmt::format("{} segments", offer.segments.size());
  if (!offer.pixel_mm || !offer.apart_mm)
    return fmt::format("{} x {} pixels, {} slices", offer.columns, offer.rows, offer.slices);
  return fmt::format("{} x {} pixels of {:.3g} x {:.3g} mm, {} slices {:.3g} mm apart", offer.columns, offer.rows,
                     (*offer.pixel_mm)[0], (*offer.pixel_mm)[1], offer.slices, *offer.apart_mm);
}

/// The place of the one that was pressed.
std::optional<std::size_t> chosen_of(const std::vector<SeriesOffer>& series, const Interface& interface) {
  std::optional<std::size_t> chosen;
  widgets::remark(interface, "There are several series of images in it. Which one is to be seen?");
  constexpr std::size_t rows_seen = 6;
  const float row = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginChild("series", {0, row * static_cast<float>(std::min(series.size(), rows_seen))});
  for (std::size_t n = 0; n < series.size(); ++n) {
    const SeriesOffer& offer = series[n];
    ImGui::PushID(offer.first_file.c_str());
    if (widgets::wide_button(fmt::format("{}   {}   {}", n + 1, offer.modality, offer.description).c_str())) chosen = n;
    widgets::remark(interface, size_in_words(offer));
    ImGui::PopID();
  }
  ImGui::EndChild();
  return chosen;
}

}  // namespace

VolumeAnswer volume_dialog(VolumeQuestion& question, const Interface& interface) {
  if (!question.series.empty()) {
    if (const auto place = chosen_of(question.series, interface)) return {about_series(question, *place), true};
    return {{}, widgets::wide_button("Cancel")};
  }
  draw_anew(question);
  if (question.preview) {
    widgets::remark(interface, size_in_words(*question.preview));
    const float side = scaled(320), left = ImGui::GetCursorPosX() + side + scaled(20), top = ImGui::GetCursorPosY();
    ImGui::BeginGroup();
    slice_in_outline(question, side);
    if (question.preview->values.size[2] > 1) {
      double slice = static_cast<double>(question.slice);
      ImGui::BeginChild("slices", {side, 2 * ImGui::GetFrameHeightWithSpacing()});
      if (widgets::slider("Slice", slice, 0, static_cast<double>(question.preview->values.size[2] - 1), "%.0f"))
        question.slice = static_cast<std::size_t>(std::lround(slice));
      ImGui::EndChild();
    }
    ImGui::EndGroup();
    ImGui::SetCursorPos({left, top});
    ImGui::BeginChild("answers", {0, side + 2 * ImGui::GetFrameHeightWithSpacing()});
    ask(question, interface);
    ImGui::EndChild();
  } else {
    widgets::remark(interface, question.reading
                                   ? fmt::format("Reading its slices\xE2\x80\xA6 {:.0f} %", 100 * question.read)
                                   : "This is a volume.");
    ask(question, interface);
  }
  if (question.answered() && widgets::wide_button("Make the model", widgets::Emphasis::strong))
    return {answer_of(question), true};
  return {{}, widgets::wide_button("Cancel")};
}

}  // namespace odontoscope
