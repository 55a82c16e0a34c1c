#pragma once
// How the interface looks: calm and dark, so that the tooth is the brightest thing on the screen.

#include <imgui.h>

#include "assets/theme.h"

namespace odontoscope::theme {

// Sizes in the interface's pixels; the scale of the screen multiplies them.
inline constexpr float text_size = 15, small_size = 13, large_size = 19;
inline constexpr float panel_width = 308;

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u, alpha);
}

inline constexpr ImU32 panel = rgb(assets::theme::interface::dark::panel),
                       raised = rgb(assets::theme::interface::dark::raised),
                       hovered = rgb(assets::theme::interface::dark::hovered),
                       pressed = rgb(assets::theme::interface::dark::pressed),
                       line = rgb(assets::theme::interface::dark::line);
inline constexpr ImU32 text = rgb(assets::theme::interface::dark::text),
                       quiet = rgb(assets::theme::interface::dark::quiet);
inline constexpr ImU32 accent = rgb(assets::theme::interface::dark::accent),
                       accent_dark = rgb(assets::theme::interface::dark::accent_dark);
/// Green, amber and red that the colour-blind can tell apart by lightness; words and signs go with them.
inline constexpr ImU32 good = rgb(assets::theme::interface::dark::good),
                       amber = rgb(assets::theme::interface::dark::amber),
                       bad = rgb(assets::theme::interface::dark::bad);
inline constexpr ImU32 good_back = rgb(assets::theme::interface::dark::good_back),
                       amber_back = rgb(assets::theme::interface::dark::amber_back),
                       bad_back = rgb(assets::theme::interface::dark::bad_back);
/// Marks in the picture, over light and dark alike.
inline constexpr ImU32 mark = rgb(assets::theme::interface::dark::mark), mark_outline = rgb(0x14171a, 200);

void apply(ImGuiStyle& style, float scale);

}  // namespace odontoscope::theme
