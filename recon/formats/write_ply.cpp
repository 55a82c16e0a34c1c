#include "recon/formats/write_ply.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>

#include "recon/core/error.h"
#include "recon/formats/little_endian.h"

namespace odontoscope {

std::string ply_bytes(const WrittenModel& model) {
  std::size_t points = 0, triangles = 0;
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment made by odontoscope; millimetres\n";
  for (std::size_t i = 0; i < model.solids.size(); ++i) {
    const WrittenSurface& solid = model.solids[i];
    points += solid.surface.points.size();
    triangles += solid.surface.triangles.size();
    bytes += fmt::format("comment structure {} {}\n", i + 1, solid.structure);
  }
  if (points > std::numeric_limits<std::uint32_t>::max()) {
    throw UsageError("the model has too many points for PLY", "Simplify it with --triangles");
  }
  bytes += fmt::format(
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\nproperty int structure\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      points, triangles);
  constexpr std::size_t point_size = 3 * sizeof(double) + 4, triangle_size = 1 + 3 * sizeof(std::uint32_t);
  bytes.reserve(bytes.size() + point_size * points + triangle_size * triangles);
  std::int32_t structure = 0;
  for (const WrittenSurface& solid : model.solids) {
    ++structure;
    for (const Point3& p : solid.surface.points) {
      for (const double coordinate : {p.x, p.y, p.z}) append(bytes, coordinate);
      append(bytes, structure);
    }
  }
  std::uint32_t first = 0;
  for (const WrittenSurface& solid : model.solids) {
    for (const Triangle& t : solid.surface.triangles) {
      append(bytes, std::uint8_t{3});
      for (const PointIndex v : t) append(bytes, static_cast<std::uint32_t>(first + v));
    }
    first += static_cast<std::uint32_t>(solid.surface.points.size());
  }
  return bytes;
}

}  // namespace odontoscope
