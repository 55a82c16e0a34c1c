#pragma once
// What makes each figure, for the table in figures.cpp.

#include "engine/figures/figure.h"
#include "engine/figures/tooth_models.h"

namespace odontoscope::figures {

Figure tooth_and_contours(ToothModels& tooth);    // 1
Figure reverse_tetrahedra(ToothModels& tooth);    // 2
Figure singular_edge(ToothModels& tooth);         // 3
Figure subdivision(ToothModels& tooth);           // 4
Figure tooth_by_db(ToothModels& tooth);           // 5
Figure tooth_by_dt(ToothModels& tooth);           // 6
Figure consecutive_contours(ToothModels& tooth);  // 7
Figure overlap_patterns(ToothModels& tooth);      // 8
Figure dt_separates(ToothModels& tooth);          // 9
Figure dt_forced(ToothModels& tooth);             // 10
Figure db_connects(ToothModels& tooth);           // 11
Figure db_between(ToothModels& tooth);            // 12
Figure singularities(ToothModels& tooth);         // 13
Figure singularity_meshes(ToothModels& tooth);    // 14
Figure mesh_details(ToothModels& tooth);          // 15
Figure decimated_shaded(ToothModels& tooth);      // 16
Figure inside_the_tooth(ToothModels& tooth);      // 17
Figure slab_volume(ToothModels& tooth);           // 18

}  // namespace odontoscope::figures
