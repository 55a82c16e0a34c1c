#pragma once
// The dialog that asks where a volume's surface lies, beside a slice with the outline that the answer would give, and
// the grey values. Of several DICOM series it asks first which one is meant.

#include <optional>

#include "engine/ui/interface.h"
#include "engine/viewer/open/volume_question.h"

namespace odontoscope {

struct VolumeAnswer {
  std::optional<LoadRequest> open;  // what is to be made, or asked about next
  bool put_away = false;            // the dialog has done its work
};

/// What the dialog holds below its title.
VolumeAnswer volume_dialog(VolumeQuestion& question, const Interface& interface);

}  // namespace odontoscope
