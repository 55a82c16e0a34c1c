#pragma once
// What all that is drawn over the picture needs.

#include <imgui.h>

#include <algorithm>
#include <glm/vec2.hpp>

#include "engine/ui/area.h"

namespace odontoscope {

inline ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }
inline ImVec2 vec(const glm::dvec2& p) { return vec(p.x, p.y); }

/// The colour with its opacity times `opacity`, of [0, 1].
inline ImU32 faded(ImU32 colour, double opacity) {
  const auto alpha = static_cast<ImU32>(std::clamp(opacity, 0.0, 1.0) * (colour >> IM_COL32_A_SHIFT));
  return (colour & ~IM_COL32_A_MASK) | alpha << IM_COL32_A_SHIFT;
}

/// Nothing is drawn beyond the area as long as this is there.
class ClipTo {
 public:
  ClipTo(ImDrawList& list, const Area& area) : list_(list) {
    list.PushClipRect(vec(area.left, area.top), vec(area.left + area.width, area.top + area.height));
  }
  ~ClipTo() { list_.PopClipRect(); }
  ClipTo(const ClipTo&) = delete;
  ClipTo& operator=(const ClipTo&) = delete;

 private:
  ImDrawList& list_;
};

void draw_dot(ImDrawList& list, const ImVec2& place, float scale);
/// In the middle of the area.
void draw_cross(const Area& area, float scale);
/// Words that can be read on any ground.
void outlined(ImDrawList& list, ImFont* font, float size, const ImVec2& place, ImU32 colour, const char* words);

}  // namespace odontoscope
