#include "engine/app/tour_cameras.h"

#include <algorithm>

#include "engine/app/whole_structures.h"
#include "engine/navigate/tour_camera_path.h"
#include "recon/cavity/tooth_axis.h"

namespace odontoscope::app {
namespace {

/// From corner to corner of the box round all surfaces: nothing is farther from an eye inside.
double diagonal(const WrittenModel& model) {
  Point3 low = model.solids.front().surface.points.front(), high = low;
  for (const WrittenSurface& solid : model.solids) {
    for (const Point3& p : solid.surface.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return length(high - low);
}

}  // namespace

CentreLines lines_inside(const WrittenModel& model, std::string_view option, Session& session) {
  const std::vector<Cavity> cavities = cavities_in(sound_structures(model));
  if (cavities.empty())
    throw UsageError(std::string(option) + ": there is no void inside",
                     std::string("Leave it out. ") + what_a_void_takes);
  return centre_lines(cavities.front(), {tooth_axis(sound_structures(model)).along}, session.progress());
}

std::vector<CameraPath> tour_cameras(const WrittenModel& model, const CentreLines& lines) {
  std::vector<CameraPath> paths;
  for (const CentreLine& canal : lines.canals) paths.push_back(camera_path(Tour(canal), canal.name, diagonal(model)));
  if (paths.empty()) throw UsageError("--tours: the void has no canal", "Leave it out.");
  return paths;
}

std::vector<GlbHotspot> hotspots_of(const CentreLines& lines) {
  std::vector<GlbHotspot> hotspots;
  if (lines.has_chamber) hotspots.push_back({"pulp chamber", lines.chamber});
  for (const CentreLine& canal : lines.canals) {
    if (canal.orifice > 0) hotspots.push_back({canal.name + ", orifice", canal.points[canal.orifice].at});
    hotspots.push_back({canal.name + ", tip", canal.end});
  }
  return hotspots;
}

}  // namespace odontoscope::app
