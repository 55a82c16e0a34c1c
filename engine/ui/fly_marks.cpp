#include "engine/ui/fly_marks.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/ui/theme.h"

namespace odontoscope {

namespace {

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

/// Clear in the middle, dark at the rim, by rings of triangles whose corners are shaded.
void draw_vignette(ImDrawList& list, const Area& viewport, double strength) {
  constexpr int around = 48;
  const double x = viewport.left + viewport.width / 2, y = viewport.top + viewport.height / 2;
  const double outer = 0.5 * std::hypot(viewport.width, viewport.height), inner = outer * (0.80 - 0.42 * strength);
  const auto rim = theme::rgb(0x000000, static_cast<unsigned>(std::lround(255 * std::clamp(1.25 * strength, 0.0, 1.0)))), clear = theme::rgb(0x000000, 0);
  const ImVec2 white = ImGui::GetDrawListSharedData() ? ImGui::GetFontTexUvWhitePixel() : ImVec2(0, 0);
  list.PushClipRect(vec(viewport.left, viewport.top), vec(viewport.left + viewport.width, viewport.top + viewport.height));
  list.PrimReserve(6 * around, 2 * around);
  const unsigned first = list._VtxCurrentIdx;
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    list.PrimWriteVtx(vec(x + inner * std::cos(angle), y + inner * std::sin(angle)), white, clear);
    list.PrimWriteVtx(vec(x + 1.02 * outer * std::cos(angle), y + 1.02 * outer * std::sin(angle)), white, rim);
  }
  for (unsigned i = 0; i < around; ++i) {
    const unsigned a = first + 2 * i, b = first + 2 * ((i + 1) % around);
    for (const unsigned corner : {a, a + 1, b, b, a + 1, b + 1}) list.PrimWriteIdx(static_cast<ImDrawIdx>(corner));
  }
  list.PopClipRect();
}

}  // namespace

void draw_fade(const ViewerState& state, const Area& viewport) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const FlyState& fly = state.fly;
  if (fly.on && state.settings.comfort.vignette && fly.turning > 0) draw_vignette(list, viewport, fly.turning);
  if (fly.dark > 0)
    list.AddRectFilled(vec(viewport.left, viewport.top), vec(viewport.left + viewport.width, viewport.top + viewport.height),
                       theme::rgb(0x000000, static_cast<unsigned>(std::lround(255 * std::clamp(fly.dark, 0.0, 1.0)))));
}

}  // namespace odontoscope
