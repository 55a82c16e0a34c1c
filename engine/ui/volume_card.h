#pragma once
// The card that asks where a volume's surface lies, beside a slice with the outline that the answer would give, and the grey values.

#include "engine/ui/interface.h"
#include "engine/ui/volume_question.h"

namespace odontoscope {

enum class VolumeAnswer { none, make, cancel };

/// What the card holds below its title.
VolumeAnswer volume_card(VolumeQuestion& question, const Interface& interface);

}  // namespace odontoscope
