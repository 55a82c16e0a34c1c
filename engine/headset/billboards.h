#pragma once
// What is written in the room beside the panel: the name of what a trigger met, a distance, the canals' names. As
// values; who draws them knows letters.

#include <string>
#include <vector>

#include "engine/headset/visit.h"

namespace odontoscope {

struct Billboard {
  std::string words;
  glm::dvec3 at{0};  // metres in the room: the middle of its lower edge
  glm::dvec3 of{0};  // what it speaks of
};

/// Towards the head, so that what they speak of does not lie before them; nearest first. Names of canals are hidden by
/// walls, and by nearer ones that they would run into.
std::vector<Billboard> billboards(const Visit& visit, const HeadsetInput& input, const VisitWorld& world);

/// Upright and towards the eyes, of a height that is read everywhere alike: an angle. `aspect` is width over height.
struct BillboardShape {
  Pose pose;
  glm::dvec2 size{0};
};
BillboardShape shape_of(const Billboard& billboard, const Pose& head, double aspect);

/// What else is drawn with lines: the hands' rays, what is measured or named; two places of the room a line, a dot
/// where they are one.
std::vector<glm::dvec3> room_marks(const Visit& visit, const HeadsetInput& input, const VisitWorld& world);

}  // namespace odontoscope
