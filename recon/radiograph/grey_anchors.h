#pragma once
// What the grey values of a volume mean, as far as they say so themselves.

#include "recon/volume/volume.h"

namespace odontoscope {

/// Two values from which all others follow in proportion: `air` is less.
struct GreyAnchors {
  double air = 0, dentine = 1;
};

/// The middle (median) value of what lies below Otsu's threshold, and of what lies from it on: in a scan of a tooth
/// most of that is dentine. Throws InputError nothing-crosses-iso where all values are equal. Precondition: `volume`
/// passes validate_volume.
GreyAnchors grey_anchors(const Volume& volume);

}  // namespace odontoscope
