#include "recon/output/solid_walls.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "recon/core/error.h"
#include "recon/delaunay/face_table.h"
#include "recon/formats/json_values.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

/// In order of the tetrahedra.
std::vector<WallFace> outer_faces(const TetraMesh& mesh) {
  using delaunay::FaceTable;
  std::vector<Triangle> outer;
  delaunay::each_outer_face(mesh.tetrahedra, [&](const Triangle& triangle) { outer.push_back(triangle); });
  FaceTable table(mesh.tetrahedra.size() * 4);  // room for the inner faces too, which are asked for below
  for (std::uint32_t i = 0; i < outer.size(); ++i) table(outer[i][0], outer[i][1], outer[i][2]) = i;
  std::vector<WallFace> faces(outer.size());
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    for (int i = 0; i < 4; ++i) {
      const auto& f = outward_face[i];
      const Tetrahedron& corners = mesh.tetrahedra[t];
      const std::uint32_t number = table(corners[f[0]], corners[f[1]], corners[f[2]]);
      if (number != FaceTable::vacant) faces[number] = {t, i, outer[number]};
    }
  }
  return faces;
}

struct Range {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

}  // namespace

std::vector<Wall> walls_of(const Solid& solid) {
  const std::vector<WallFace> faces = outer_faces(solid.tetrahedra);
  SurfaceMesh boundary{solid.tetrahedra.points, {}};
  for (const WallFace& face : faces) boundary.triangles.push_back(face.triangle);
  const SurfaceReport report = inspect(boundary);
  std::vector<Wall> walls;
  for (const Shell::Kind kind : {Shell::Kind::external, Shell::Kind::cavity, Shell::Kind::open}) {
    Wall wall{solid.structure + " " + name(kind), {}};
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (report.shells[report.shell_of[i]].kind == kind) wall.faces.push_back(faces[i]);
    }
    if (!wall.faces.empty()) walls.push_back(std::move(wall));
  }
  return walls;
}

std::optional<CrownLimit> crown_limit(const Reconstruction& reconstruction) {
  Range enamel, all;
  for (const Solid& solid : reconstruction.solids) {
    const bool is_enamel = solid.structure.substr(0, solid.structure.find('+')) == "enamel";
    for (const Point3& p : solid.tetrahedra.points) {
      all.add(p.z);
      if (is_enamel) enamel.add(p.z);
    }
  }
  if (!(enamel.low <= enamel.high)) return std::nullopt;
  const bool above = enamel.low + enamel.high >= all.low + all.high;
  const CrownLimit limit{above ? enamel.low : enamel.high, above};
  if (limit.in_crown(above ? all.low : all.high)) return std::nullopt;
  return limit;
}

}  // namespace odontoscope
