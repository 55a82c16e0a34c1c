#pragma once
// A frame round the section plane, by which a hand takes hold of it: in the room, as large as what it cuts.

#include <array>
#include <optional>

#include "engine/headset/stage.h"
#include "engine/scene/scene.h"

namespace odontoscope {

/// Its corners in the room, one after the other; it encloses what the plane can cut of the model's box, and a little
/// more.
using SectionFrame = std::array<glm::dvec3, 4>;
SectionFrame section_frame(const Section& section, const Stage& stage, const Model& model);

/// The place of the frame that a hand means: that its ray passes within a finger's breadth, or that is within its
/// reach. Empty if there is none.
std::optional<glm::dvec3> meant(const SectionFrame& frame, const Pose& grip, const Pose& aim);

/// As the hand went that holds it; it stays within the model.
Section carried(const Section& section, const Stage& stage, const Pose& from, const Pose& to, const Model& model);

}  // namespace odontoscope
