#include "engine/app/proven.h"

namespace odontoscope::app {

Proven proven_by(const Reconstruction& made) {
  Proven proven{{},
                {},
                made.counts.kept,
                made.slices_checked,
                verdict_of(made),
                headline(made),
                made.attention,
                in_words(made.changes)};
  for (const Solid& solid : made.solids) {
    proven.structures.push_back(solid.structure);
    proven.reports.push_back(solid.report);
  }
  return proven;
}

}  // namespace odontoscope::app
