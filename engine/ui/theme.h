#pragma once
// How the interface looks: calm and dark, so that the tooth is the brightest thing on the screen.

#include <imgui.h>

namespace odontoscope::theme {

// Sizes in the interface's pixels; the scale of the screen multiplies them.
inline constexpr float text_size = 15, small_size = 13, large_size = 19;
inline constexpr float panel_width = 308;

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u, alpha);
}

inline constexpr ImU32 panel = rgb(0x1a1e23), raised = rgb(0x252b32), hovered = rgb(0x303841), pressed = rgb(0x3a444f),
                       line = rgb(0x323a43);
inline constexpr ImU32 text = rgb(0xe6eaee), quiet = rgb(0x98a4b0);
inline constexpr ImU32 accent = rgb(0x4fb3bf), accent_dark = rgb(0x2b6f78);
/// Green, amber and red that the colour-blind can tell apart by lightness; words and signs go with them.
inline constexpr ImU32 good = rgb(0x5ec98f), amber = rgb(0xf4bf4f), bad = rgb(0xf2705c);
inline constexpr ImU32 good_back = rgb(0x1f3a2e), amber_back = rgb(0x3f3318), bad_back = rgb(0x45262a);
/// Marks in the picture, over light and dark alike.
inline constexpr ImU32 mark = rgb(0xffc94d), mark_outline = rgb(0x14171a, 200);

void apply(ImGuiStyle& style, float scale);

}  // namespace odontoscope::theme
