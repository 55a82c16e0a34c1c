#include "engine/comparison/artefacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "engine/navigate/screen.h"
#include "engine/scene/glm_vector.h"
#include "recon/mesh/faulty_edges.h"

namespace odontoscope {

namespace {

/// Half of what the picture spans from top to bottom at an artefact, over the grid's spacing.
constexpr double seen_cells = 9;

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 1e-12 ? v / length : otherwise;
}

/// From the inside corners of both cells to the outside ones.
glm::dvec3 outward_at(const Grid& grid, const Field& field, const Defect& defect) {
  glm::dvec3 inside(0), outside(0);
  double in = 0, out = 0;
  for (const GridPlace& cell : {defect.first, defect.second}) {
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      const std::size_t column = cell[0] + (corner & 1), row = cell[1] + (corner >> 1 & 1),
                        layer = cell[2] + (corner >> 2 & 1);
      const bool material = field.values[grid.index(column, row, layer)] < 0;
      (material ? inside : outside) += vec(grid.point(column, row, layer));
      (material ? in : out) += 1;
    }
  }
  if (in == 0 || out == 0) return {0, 0, 1};
  return unit_or(outside / out - inside / in, {0, 0, 1});
}

DefectKind kind_of(EdgeFault fault) {
  switch (fault) {
    case EdgeFault::boundary:
      return DefectKind::crack;
    case EdgeFault::misoriented:
      return DefectKind::misoriented;
    case EdgeFault::nonmanifold:
      break;
  }
  return DefectKind::nonmanifold;
}

bool before(const ComparisonArtefact& a, const ComparisonArtefact& b) {
  constexpr std::array order = {0, 2, 1};  // crack, misoriented, nonmanifold as DefectKind counts them
  return order[static_cast<std::size_t>(a.kind)] < order[static_cast<std::size_t>(b.kind)];
}

}  // namespace

std::vector<ComparisonArtefact> artefacts_of(const std::string& structure, const Grid& grid, const Field& field,
                                             const std::vector<Defect>& defects) {
  struct Gathered {
    const Defect* first = nullptr;
    glm::dvec3 sum{0};
    double count = 0;
  };
  std::map<std::tuple<DefectKind, GridPlace, int>, Gathered> faces;
  for (const Defect& defect : defects) {
    Gathered& face = faces[{defect.kind, defect.second, defect.axis}];
    if (!face.first) face.first = &defect;
    face.sum += vec(defect.at);
    ++face.count;
  }
  std::vector<ComparisonArtefact> artefacts;
  artefacts.reserve(faces.size());
  for (const auto& [key, face] : faces)
    artefacts.push_back(
        {structure, face.first->kind, face.sum / face.count, outward_at(grid, field, *face.first), *face.first});
  std::stable_sort(artefacts.begin(), artefacts.end(), before);
  return artefacts;
}

std::vector<ComparisonArtefact> artefacts_of(const std::string& structure, const SurfaceMesh& mesh) {
  const auto normal_at = [&](HalfEdge h) {
    const Triangle& t = mesh.triangles[h / 3];
    const glm::dvec3 a = vec(mesh.points[t[0]]), b = vec(mesh.points[t[1]]), c = vec(mesh.points[t[2]]);
    return unit_or(glm::cross(b - a, c - a), {0, 0, 1});
  };
  std::vector<ComparisonArtefact> artefacts;
  for (const auto& [fault, h] : faulty_edges(mesh)) {
    const glm::dvec3 middle = 0.5 * (vec(mesh.points[start(mesh, h)]) + vec(mesh.points[end(mesh, h)]));
    artefacts.push_back({structure, kind_of(fault), middle, normal_at(h), std::nullopt});
  }
  std::stable_sort(artefacts.begin(), artefacts.end(), before);
  return artefacts;
}

std::vector<ComparisonArtefact> in_telling_order(std::vector<ComparisonArtefact> artefacts) {
  std::stable_sort(artefacts.begin(), artefacts.end(), before);
  const auto misoriented = std::find_if(artefacts.begin(), artefacts.end(),
                                        [](const ComparisonArtefact& a) { return a.kind == DefectKind::misoriented; });
  const std::vector<ComparisonArtefact> in_place(misoriented, artefacts.end());
  const std::size_t count = in_place.size();
  if (count < 3) return artefacts;
  // A step of the golden section, with no common divisor, visits each once and never a neighbour next.
  std::size_t step = static_cast<std::size_t>(0.6180339887 * static_cast<double>(count));
  while (step > 1 && std::gcd(step, count) != 1) --step;
  const auto first = static_cast<std::size_t>(misoriented - artefacts.begin());
  for (std::size_t i = 0; i < count; ++i) artefacts[first + i] = in_place[i * std::max<std::size_t>(step, 1) % count];
  return artefacts;
}

std::string in_words(const ComparisonArtefact& artefact, CaseTable table) {
  if (artefact.reason) return in_words(*artefact.reason, table);
  std::string after = fmt::format(
      " Decimation moved what table {} had made; without decimation the two cells that disagree can be named.",
      name(table));
  switch (artefact.kind) {
    case DefectKind::crack:
      return "An edge with a triangle on one side only: the surface is open here." + after;
    case DefectKind::misoriented:
      return "The two triangles of this edge face opposite sides: one is invisible once back faces are culled." + after;
    case DefectKind::nonmanifold:
      return "More than two triangles meet in this edge." + after;
  }
  return after;
}

Camera camera_at(const ComparisonArtefact& artefact, double spacing_mm, const Camera& start, const Pickable& pickable,
                 const Scene& scene) {
  Camera camera = start;
  camera.target = artefact.at;
  camera.height_mm = 2 * seen_cells * spacing_mm;
  const double distance = seen_cells * spacing_mm / std::tan(glm::radians(start.field_of_view_deg) / 2);
  const glm::dvec3 out = unit_or(artefact.outward, {0, 0, 1});
  const glm::dvec3 across =
      unit_or(glm::cross(std::abs(out.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), out), {1, 0, 0});
  const glm::dvec3 along = glm::cross(out, across);
  const auto look_from = [&](const glm::dvec3& towards, double far) {
    camera.position = artefact.at + far * towards;
    camera.up = std::abs(towards.z) < 0.95 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  };
  double largest_clearance = -1;
  glm::dvec3 roomiest = out;
  for (const double tilt : {0.0, 0.4, 0.8, 1.15}) {
    for (int round = 0; round < (tilt > 0 ? 12 : 1); ++round) {
      const double turn = glm::radians(30.0) * round;
      const glm::dvec3 towards =
          glm::normalize(std::cos(tilt) * out + std::sin(tilt) * (std::cos(turn) * along + std::sin(turn) * across));
      const auto in_the_way = pick(pickable, scene, {artefact.at + distance * towards, -towards});
      if (!in_the_way || in_the_way->distance_mm > distance - 1.5 * spacing_mm) {
        look_from(towards, distance);
        return camera;
      }
      const auto wall = pick(pickable, scene, {artefact.at + 0.5 * spacing_mm * towards, towards});
      const double room = wall ? wall->distance_mm : distance;
      if (room <= largest_clearance) continue;
      largest_clearance = room;
      roomiest = towards;
    }
  }
  // Inside a canal: as far back as its wall lets one.
  look_from(roomiest, 0.5 * spacing_mm + 0.9 * largest_clearance);
  return camera;
}

std::size_t wall_around(const ComparisonArtefact& artefact, double spacing_mm, const Pickable& pickable,
                        const Scene& scene) {
  constexpr int places = 8;
  constexpr double aside = 4, in_depth = 4;  // grid spacings
  const Camera camera = camera_at(artefact, spacing_mm, scene.camera, pickable, scene);
  const CameraAxes axes = axes_of(camera);
  const double distance = glm::distance(camera.position, artefact.at);
  std::size_t met = 0;
  for (int i = 0; i < places; ++i) {
    const double turn = 2 * glm::pi<double>() * i / places;
    const glm::dvec3 place =
        artefact.at + aside * spacing_mm * (std::cos(turn) * axes.right + std::sin(turn) * axes.up);
    const auto hit = pick(pickable, scene, {camera.position, glm::normalize(place - camera.position)});
    met += hit && std::abs(hit->distance_mm - distance) < in_depth * spacing_mm;
  }
  return met;
}

std::vector<ComparisonArtefact> cracks_on_walls_first(std::vector<ComparisonArtefact> artefacts, double spacing_mm,
                                                      const Pickable& pickable, Scene scene) {
  constexpr std::size_t most = 100;
  struct Placed {
    ComparisonArtefact artefact;
    std::size_t wall = 0;
  };
  std::vector<Placed> cracks;
  for (const ComparisonArtefact& artefact : artefacts) {
    if (cracks.size() == most || artefact.kind != DefectKind::crack) break;
    for (Look& look : scene.looks) look.visible = look.structure == artefact.structure;
    cracks.push_back({artefact, wall_around(artefact, spacing_mm, pickable, scene)});
  }
  std::stable_sort(cracks.begin(), cracks.end(), [](const Placed& a, const Placed& b) { return a.wall > b.wall; });
  for (std::size_t i = 0; i < cracks.size(); ++i) artefacts[i] = std::move(cracks[i].artefact);
  return artefacts;
}

}  // namespace odontoscope
