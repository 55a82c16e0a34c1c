#pragma once
// Which surfaces are drawn inside out. What draws and what picks must agree.

#include "engine/scene/scene.h"

namespace odontoscope {

/// `cavity`: the surface is no solid's outer one; `capped`: a section is on, and the eye is on the side that was cut
/// away. Cut open, a cavity shows its wall: as a body it would show its inside, which is culled, and one would look
/// through the solid. Only CT values close it.
inline bool turned_out(const Scene& scene, const Look& look, bool cavity, bool capped) {
  const bool open = capped && cavity && scene.cap.shows != CapLook::Shows::ct;
  return look.as_body && !open;
}

}  // namespace odontoscope
