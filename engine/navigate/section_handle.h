#pragma once
// The handle by which a section plane is moved and turned in the picture: a knob in the plane that slides along its
// normal, and an arrow whose tip turns it. What is drawn and what is hit come from the same places.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "engine/navigate/screen.h"
#include "engine/scene/scene.h"

namespace odontoscope {

enum class SectionGrip { slide, turn };

/// Places in the picture as in screen.h.
struct SectionHandle {
  glm::dvec2 knob{0}, tip{0};
  std::vector<glm::dvec2> outline;  // of a disc in the plane, to be joined by lines
  bool tip_faces_eye = true;        // false: the arrow points away
};

/// The same size in the picture wherever the eye is: `reach` is the arrow's length there. Empty if it is behind the
/// eye.
std::optional<SectionHandle> section_handle(const Section& section, const Camera& camera, double reach);

std::optional<SectionGrip> grip_at(const SectionHandle& handle, const glm::dvec2& place, double tolerance);

/// The plane after the hand went from `from` to `to`. It stays within the model.
Section dragged(const Section& section, SectionGrip grip, const Camera& camera, double reach, const glm::dvec2& from,
                const glm::dvec2& to, const Model& model);

/// Distance of the plane from the model's centre along its normal; positive where the normal points.
double offset_of(const Section& section, const Model& model);
/// The plane at that distance; its point is the one nearest to the model's centre.
Section with_offset(const Section& section, double offset_mm, const Model& model);

/// Away, or back as it was put away; `fresh` where none was.
void toggle_section(std::optional<Section>& section, std::optional<Section>& put_away, const Section& fresh);

/// The normal as two angles, for sliders: round the tooth's axis from buccal towards mesial, and up towards occlusal.
struct SectionAngles {
  double round_deg = 0, up_deg = 0;
};
SectionAngles angles_of(const Section& section, const AnatomicalFrame& frame = {});
glm::dvec3 normal_of(const SectionAngles& angles, const AnatomicalFrame& frame = {});

}  // namespace odontoscope
