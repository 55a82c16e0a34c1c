#pragma once
// A transfer function over the histogram of its volume, to be edited by the mouse, and point by point by the keyboard.

#include <cstddef>
#include <vector>

#include "engine/scene/volume_look.h"
#include "engine/ui/interface.h"
#include "engine/viewer/loading.h"

namespace odontoscope {

/// Bars of the histogram in the colours that their values are shown in, lines where surfaces were taken, and the
/// function's points: dragged they change, a click beside them makes one, the right button takes one away (two are
/// left). Below, the chosen point's colour and numbers. `chosen`: kept from frame to frame. true: `transfer` changed;
/// it stays sensible(). Preconditions: it is, and has two points at least.
bool transfer_editor(const GreyValues& greys, std::vector<TransferPoint>& transfer, std::size_t& chosen,
                     const Interface& interface, float height);

}  // namespace odontoscope
