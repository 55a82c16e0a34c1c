#include "engine/headset_viewer/headset_texture.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/ui/theme.h"

namespace odontoscope {

namespace {

/// Two pixels a millimetre of the panel, somewhat more than headsets resolve at its distance.
constexpr int panel_width = 880, panel_height = 920, label_height = 60, label_rows = 8, label_columns = 2;
constexpr PixelSize sheet_size{panel_width, panel_height + label_rows* label_height};
/// Pixels for one of the interface's: capital letters are then 11 mm high, one degree at the panel's distance.
constexpr float scale = 2.35f;
/// Without a hand on it: often enough for what is told there.
constexpr double rest_seconds = 0.15;
constexpr float nowhere = -1e6f;

}  // namespace

HeadsetTexture::HeadsetTexture(const Gl& gl, const ShaderLibrary& shaders, HeadsetPage page)
    : gl_(&gl),
      interface_pass_(gl, shaders),
      billboard_pass_(gl, shaders),
      texture_(gl, {sheet_size, {GL_RGBA8}}),
      page_(page) {}

glm::dvec2 HeadsetTexture::on_panel(double x, double y) { return {x / panel_width, y / panel_height}; }

void HeadsetTexture::feed(const Visit& visit, const HeadsetInput& input, double seconds) {
  const std::optional<std::size_t> hand = panel_hand(visit);
  const glm::dvec2 at =
      hand ? visit.hands.on_panel[*hand]->at * glm::dvec2(panel_width, panel_height) : glm::dvec2(nowhere);
  interface_.feed(MouseMoved{at.x, at.y});
  const bool down = hand && visit.hands.pressing[*hand];
  if (down != down_) interface_.feed(MouseButtonChanged{MouseButton::left, down});
  down_ = down;
  constexpr double notches_per_second = 12, at_rest = 0.15;
  if (hand && std::abs(input.hands[*hand].stick.y) > at_rest)
    interface_.feed(Scrolled{0, seconds * notches_per_second * input.hands[*hand].stick.y});
}

void HeadsetTexture::update(Visit& visit, const HeadsetInput& input, const VisitWorld& world,
                            const HeadsetPanelWords& words, double seconds) {
  const std::vector<Billboard> billboards = odontoscope::billboards(visit, input, world);
  std::vector<std::string> wanted;
  for (const Billboard& billboard : billboards) wanted.push_back(billboard.words);
  waited_ += seconds;
  const bool hand_on_it = panel_hand(visit) || down_;
  if (hand_on_it || waited_ > rest_seconds || wanted != written_) {
    feed(visit, input, waited_ > 1 ? seconds : waited_);
    interface_.begin({sheet_size, scale, std::min(waited_, 1.0)});
    if (visit.panel) draw_headset_panel(visit, page_, world, words, interface_, panel_width, panel_height);
    write(billboards, input.head);
    if (const auto hand = panel_hand(visit)) {  // over everything
      const ImVec2 at = ImGui::GetIO().MousePos;
      ImGui::GetForegroundDrawList()->AddCircleFilled(at, 4.5f * scale, theme::mark_outline, 24);
      ImGui::GetForegroundDrawList()->AddCircleFilled(at, 3.2f * scale,
                                                      visit.hands.pressing[*hand] ? theme::text : theme::mark, 24);
    }
    const ImDrawData& drawn = *interface_.end();
    texture_.bind();
    gl_->Disable(GL_SCISSOR_TEST);
    constexpr GLfloat nothing[4] = {0, 0, 0, 0};
    gl_->ClearBufferfv(GL_COLOR, 0, nothing);
    interface_pass_.draw(interface_, drawn, {texture_.id(), 0, 0, sheet_size});
    waited_ = 0;
    written_ = std::move(wanted);
  } else {
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      const BillboardShape shape = shape_of(billboards[i], input.head, labels_[i].width / labels_[i].height);
      labels_[i].pose = shape.pose;
      labels_[i].size = shape.size;
    }
  }
  place(visit, input);
}

/// The labels, row by row below the panel; those for which there is no room are left out.
void HeadsetTexture::write(const std::vector<Billboard>& billboards, const Pose& head) {
  labels_.clear();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImFont& font = *interface_.bold;
  for (std::size_t i = 0; i < std::min<std::size_t>(billboards.size(), label_rows * label_columns); ++i) {
    constexpr float column = static_cast<float>(panel_width) / label_columns, margin = 14, gap = 4;
    const float left = column * static_cast<float>(i % label_columns),
                top = static_cast<float>(panel_height + label_height * static_cast<int>(i / label_columns));
    const ImVec2 extent = font.CalcTextSizeA(font.FontSize, 1e9f, 0, interface_.say(billboards[i].words).c_str());
    const float width = std::min(extent.x + 2 * margin, column), height = label_height - gap;
    list.PushClipRect({left, top}, {left + width, top + height});
    list.AddRectFilled({left, top}, {left + width, top + height}, theme::rgb(0x14181c, 215), 12);
    list.AddText(interface_.bold, font.FontSize, {left + margin, top + 0.5f * (height - extent.y)}, theme::text,
                 interface_.say(billboards[i].words).c_str());
    list.PopClipRect();
    const BillboardShape shape = shape_of(billboards[i], head, width / height);
    labels_.push_back({shape.pose, shape.size, left, top, width, height});
  }
}

void HeadsetTexture::place(const Visit& visit, const HeadsetInput& input) {
  light_ = 1 - visit.seen.dark;
  // Far ones first: a near label hides a far one.
  pieces_ = labels_;
  const auto distance = [&](const SheetPiece& piece) { return glm::length(piece.pose.position - input.head.position); };
  std::sort(pieces_.begin(), pieces_.end(),
            [&](const SheetPiece& a, const SheetPiece& b) { return distance(a) > distance(b); });
  if (visit.panel) pieces_.push_back({visit.panel->pose, visit.panel->size, 0, 0, panel_width, panel_height});
  beams_.clear();
  for (std::size_t i = 0; i < 2; ++i) {
    if (!visit.hands.on_panel[i]) continue;
    const Pose& aim = input.hands[i].aim;
    beams_.push_back({aim.position,
                      aim.position + visit.hands.on_panel[i]->distance * aim.ahead(),
                      0.003,
                      {1.0f, 0.79f, 0.30f, 0.8f}});
  }
}

void HeadsetTexture::draw(const EyeView& eye, const Target& target) const {
  billboard_pass_.draw(texture_, pieces_, beams_, eye, target, light_);
}

}  // namespace odontoscope
