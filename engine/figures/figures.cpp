#include "engine/figures/figures.h"

#include <fmt/format.h>

#include <utility>

#include "engine/figures/makers.h"
#include "recon/core/error.h"

namespace odontoscope::figures {

const std::vector<Entry>& paper_figures() {
  static const std::vector<Entry> entries = {
      {1, "A tooth and the contours that it was made from", tooth_and_contours},
      {2, "Reverse tetrahedra", reverse_tetrahedra},
      {3, "A singular edge", singular_edge},
      {4, "Subdivision removes the singular edge", subdivision},
      {5, "The outside of the tooth by the distance field (DB)", tooth_by_db},
      {6, "The same tooth by Delaunay triangulation (DT)", tooth_by_dt},
      {7, "Two consecutive sections, by both methods", consecutive_contours},
      {8, "How far do contours overlap?", overlap_patterns},
      {9, "DT connects what overlaps well, and only that", dt_separates},
      {10, "DT made to connect", dt_forced},
      {11, "DB connects whatever overlaps at all", db_connects},
      {12, "DB between overlap and none", db_between},
      {13, "Where two roots become one, by both methods", singularities},
      {14, "The meshes of that place", singularity_meshes},
      {15, "Meshes of a root from near by", mesh_details},
      {16, "What decimation leaves of the DB model", decimated_shaded},
      {17, "Inside the tooth", inside_the_tooth},
      {18, "The volume between two slices", slab_volume},
  };
  return entries;
}

Figure make_figure(int number, ToothModels& tooth) {
  for (const Entry& entry : paper_figures()) {
    if (entry.number != number) continue;
    Figure figure = entry.make(tooth);
    figure.number = entry.number;
    figure.title = entry.title;
    return figure;
  }
  throw UsageError(fmt::format("the paper has no figure {}", number),
                   fmt::format("They are numbered 1 to {}", paper_figures().size()));
}

}  // namespace odontoscope::figures
