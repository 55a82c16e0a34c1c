#pragma once
// A model's part of a web page, from what the engines made.

#include <string>
#include <vector>

#include "engine/app/certificate_text.h"
#include "engine/scene/scene.h"
#include "engine/web/page.h"
#include "recon/core/progress.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/formats/written_model.h"

namespace odontoscope::app {

/// GLB and certificate; its name and words are left to the caller.
WebModel web_model(const WrittenModel& written, const Certificate& certificate);

/// Its shells; of a surface that is open all over the whole of it: a picture shows what there is.
std::vector<NamedSurface> surfaces_of(const WrittenModel& written);

/// The desktop's first look at the same surfaces, and that look in the page's words.
Scene usual_scene_of(const WrittenModel& written);
std::vector<WebLook> looks_of(const Scene& scene);
inline std::vector<WebLook> looks_of(const WrittenModel& written) { return looks_of(usual_scene_of(written)); }

/// The centre lines of the largest void's canals and horns, from the chamber to their ends; none where the void's wall
/// is not sound enough for any.
void add_ways(const WrittenModel& written, WebPage& page, const Progress& progress);

/// What a page's `language` is, of a tag, of a file or of nothing: a known one by its tag, since its texts are in every
/// page; of a file all. Throws as language_asked does.
std::string language_in_page(const std::string& asked);

/// `simplified`: its surfaces no longer bound its tetrahedra. `warnings`, without full stops, become findings.
WebModel web_model_by_dt(const Reconstruction& made, bool simplified, const std::vector<std::string>& warnings);
WebModel web_model_by_db(const DbReconstruction& made, CaseTable cases);

}  // namespace odontoscope::app
