#pragma once
// What all that is drawn over the picture needs.

#include <imgui.h>

#include <algorithm>
#include <glm/vec2.hpp>

namespace odontoscope {

inline ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }
inline ImVec2 vec(const glm::dvec2& p) { return vec(p.x, p.y); }

/// The colour with its opacity times `opacity`, of [0, 1].
inline ImU32 faded(ImU32 colour, double opacity) {
  const auto alpha = static_cast<ImU32>(std::clamp(opacity, 0.0, 1.0) * (colour >> IM_COL32_A_SHIFT));
  return (colour & ~IM_COL32_A_MASK) | alpha << IM_COL32_A_SHIFT;
}

}  // namespace odontoscope
