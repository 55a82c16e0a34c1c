#pragma once
// What a comparison cannot measure without drawing: pictures of each method's model, and how much of it one sees
// through.

#include "engine/gpu/context.h"
#include "recon/compare/compare.h"
#include "recon/core/progress.h"

namespace odontoscope::figures {

/// Fills in `pictures` (culled, two-sided, and with the faulty edges marked, all from one place) and `seen_through` of
/// every method. The first method is the closed one that tells where there is surface. The context is current. Stage:
/// "pictures". Throws GraphicsError, Cancelled.
void add_pictures(Comparison& comparison, const Gl& gl, const Progress& progress = {});

}  // namespace odontoscope::figures
