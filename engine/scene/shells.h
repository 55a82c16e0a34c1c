#pragma once
// A solid's surface as the parts that a scene tells apart.

#include <string>
#include <vector>

#include "engine/scene/model.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

/// Appends the external shells of `surface` as "S" and its cavities, if it has any, as "S cavity". `report` is that of
/// `surface`; open shells are left out.
void add_shells(const std::string& structure, const SurfaceMesh& surface, const SurfaceReport& report,
                std::vector<NamedSurface>& to);

}  // namespace odontoscope
