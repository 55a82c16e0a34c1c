#pragma once
// The JSON that reports and certificates have in common. For the .cpp files of this room only.

#include <nlohmann/json.hpp>
#include <vector>

#include "recon/mesh/surface_distance.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

using Json = nlohmann::ordered_json;

const char* name(Shell::Kind kind);
Json json_of(const Point3& place);  // three numbers
Json json_of(const OneWayDistance& distance);
Json json_of(const Distribution& distribution);
/// Counts summed over all reports, and every shell.
Json json_of(const std::vector<const SurfaceReport*>& reports);
/// Smallest angles and aspect ratios of one surface.
Json quality_json(const SurfaceReport& report);
/// With a line end. Text that is no UTF-8 is replaced, never a reason to fail.
std::string text_of(const Json& json);

}  // namespace odontoscope
