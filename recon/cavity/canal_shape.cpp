#include "recon/cavity/canal_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/cavity/limits.h"
#include "recon/cavity/tooth_axis.h"
#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/mesh/half_edges.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope {
namespace {

/// Which third of which canal is nearest to a place, below the orifices.
class Owners {
 public:
  explicit Owners(const CentreLines& lines) : canals_(lines.canals.size()) {
    for (std::size_t c = 0; c < canals_; ++c) add(lines.canals[c], c);
    for (const std::vector<CentreLine>* others : {&lines.horns, &lines.others})
      for (const CentreLine& line : *others) add(line, canals_);
  }

  struct Owner {
    std::size_t canal = 0, third = 0;  // `canal`: as many as there are canals if it is no canal
    Direction out{};                   // of a place just below an orifice: along the canal, unit
  };
  Owner of(const Point3& p) const {
    const Entry* best = &entries_.front();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Entry& entry : entries_) {
      const Direction way = entry.at - p;
      const double far = dot(way, way);
      if (far >= nearest) continue;
      nearest = far;
      best = &entry;
    }
    return best->owner;
  }
  bool any() const { return !entries_.empty(); }

 private:
  struct Entry {
    Point3 at;
    Owner owner;
  };
  void add(const CentreLine& line, std::size_t canal) {
    const double begin = line.points[line.orifice].along, whole = line.length_to_wall();
    const double before = line.orifice == 0 ? length(line.points.front().at - line.start) : 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const double part = (line.points[i].along - begin + before) / whole;
      const bool below = canal < canals_ && i >= line.orifice;
      Owner owner{below ? canal : canals_, std::min<std::size_t>(2, static_cast<std::size_t>(std::max(0.0, 3 * part)))};
      if (below && line.orifice > 0 && line.points[i].along - begin < line.points[i].ball) {
        const Direction along = cavity::direction_at(line, line.points[i].along);
        owner.out = (1 / length(along)) * along;
      }
      entries_.push_back({line.points[i].at, owner});
    }
  }
  std::size_t canals_;
  std::vector<Entry> entries_;
};

/// A triangle's area, piece by piece, to whom it is nearest.
void share_triangle(const std::array<Point3, 3>& p, double finest, const Owners& owners,
                    std::vector<CanalShape>& shapes) {
  std::size_t k = 0;
  std::array<double, 3> edges{};
  for (std::size_t e = 0; e < 3; ++e) {
    edges[e] = length(p[(e + 1) % 3] - p[e]);
    if (edges[e] > edges[k]) k = e;
  }
  if (edges[k] > finest) {
    const Point3 &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
    const Point3 middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    share_triangle({a, middle, c}, finest, owners, shapes);
    share_triangle({middle, b, c}, finest, owners, shapes);
    return;
  }
  const Point3 centre{(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3, (p[0].z + p[1].z + p[2].z) / 3};
  const Owners::Owner owner = owners.of(centre);
  if (owner.canal >= shapes.size()) return;
  const Direction normal = cross(p[1] - p[0], p[2] - p[0]);
  const bool is_floor = std::abs(dot(normal, owner.out)) > limits::floor_cosine * length(normal);
  if (!is_floor) shapes[owner.canal].thirds[owner.third].area += length(normal) / 2;
}

/// The sum over each canal's part of the wall of edge length times outer angle.
std::vector<double> surface_growth(const SurfaceMesh& wall, const Owners& owners, std::size_t canals) {
  std::vector<double> growth(canals, 0);
  const EdgeMates edges = edge_mates(wall);
  std::vector<Direction> normals;  // into the void
  for (const Triangle& t : wall.triangles)
    normals.push_back(cross(wall.points[t[1]] - wall.points[t[0]], wall.points[t[2]] - wall.points[t[0]]));
  for (HalfEdge h = 0; h < 3 * wall.triangles.size(); ++h) {
    const HalfEdge mate = edges.mate[h];
    if (mate >= EdgeMates::no_edge || mate < h) continue;
    const Point3 &a = wall.points[start(wall, h)], &b = wall.points[end(wall, h)];
    const Direction &n = normals[h / 3], &m = normals[mate / 3];
    const Direction along = b - a;
    // Seen along the edge, from one normal to the other: the void's body bulges out where its walls turn towards each
    // other.
    const double angle = portable::atan2(
        dot(cross(n, m), along) / std::max(length(along), std::numeric_limits<double>::min()), dot(n, m));
    const Owners::Owner owner = owners.of({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
    if (owner.canal < canals) growth[owner.canal] += length(along) * -angle;
  }
  return growth;
}

void measure_sections(const Cavity& cavity, const CentreLine& line, CanalShape& shape, const Progress& progress) {
  constexpr std::size_t sections = 10;  // of a third
  const double before = line.orifice == 0 ? length(line.points.front().at - line.start) : 0;
  const double whole = line.length_to_wall(), begin = line.points[line.orifice].along - before,
               step = whole / (3 * sections);
  for (std::size_t third = 0; third < 3; ++third) {
    for (std::size_t i = 0; i < sections; ++i) {
      progress.check();
      const double along = begin + (static_cast<double>(third * sections + i) + 0.5) * step;
      shape.thirds[third].volume +=
          step * cavity::section_area(cavity.wall, cavity::place_along(line, along), cavity::direction_at(line, along));
    }
  }
  for (const double far : {1.0, 2.0, 3.0, 4.0}) {
    if (far >= whole) break;
    const double along = begin + whole - far;
    const auto next =
        std::find_if(line.points.begin(), line.points.end(), [&](const CentrePoint& p) { return p.along >= along; });
    const CentrePoint& beside = next == line.points.end() ? line.points.back() : *next;
    shape.apical.push_back(
        {far, 2 * beside.ball,
         cavity::section_area(cavity.wall, cavity::place_along(line, along), cavity::direction_at(line, along))});
  }
}

}  // namespace

namespace cavity {

double section_area(const SurfaceMesh& wall, const Point3& at, const Direction& along) {
  const Upright upright(along);
  const Point3 middle = upright.turned(at);
  double round = std::numeric_limits<double>::infinity();
  const std::vector<Polygon> loops = section_loops(upright.turned(wall), middle.z);
  // The smallest loop round the place, less the islands in it.
  const Polygon* own = nullptr;
  for (const Polygon& loop : loops) {
    const double area = std::abs(signed_area(loop));
    if (area >= round || !encloses(loop, {middle.x, middle.y})) continue;
    round = area;
    own = &loop;
  }
  if (own == nullptr) return 0;
  double left = round;
  for (const Polygon& loop : loops) {
    const double area = std::abs(signed_area(loop));
    if (&loop != own && area < round && encloses(*own, loop.front())) left -= area;
  }
  return left;
}

Point3 place_along(const CentreLine& line, double along) {
  const auto next =
      std::find_if(line.points.begin(), line.points.end(), [&](const CentrePoint& p) { return p.along >= along; });
  // Before its first point and behind its last, straight on to the wall.
  const auto on = [](const Point3& from, const Point3& to, double far) {
    const Direction way = to - from;
    const double share = length(way) > 0 ? far / length(way) : 0;
    return Point3{from.x + share * way.x, from.y + share * way.y, from.z + share * way.z};
  };
  if (next == line.points.end()) return on(line.points.back().at, line.end, along - line.points.back().along);
  if (next == line.points.begin()) return on(next->at, line.start, next->along - along);
  return on((next - 1)->at, next->at, along - (next - 1)->along);
}

Direction direction_at(const CentreLine& line, double along) {
  const auto next = std::find_if(line.points.begin() + 1, line.points.end() - 1,
                                 [&](const CentrePoint& p) { return p.along >= along; });
  const auto i = static_cast<std::size_t>(next - line.points.begin());
  const std::size_t first = i > 2 ? i - 2 : 0, last = std::min(i + 2, line.points.size() - 1);
  return line.points[last].at - line.points[first].at;
}

}  // namespace cavity

std::vector<CanalShape> canal_shapes(const Cavity& cavity, const CentreLines& lines, const Progress& progress) {
  std::vector<CanalShape> shapes(lines.canals.size());
  const Owners owners(lines);
  if (shapes.empty() || !owners.any()) return shapes;
  for (std::size_t c = 0; c < shapes.size(); ++c) measure_sections(cavity, lines.canals[c], shapes[c], progress);
  double finest = std::numeric_limits<double>::infinity();
  for (const CentreLine& line : lines.canals) finest = std::min(finest, line.points[line.points.size() / 2].ball);
  // Where the canal opens to the outside there is no wall.
  for (std::size_t i = 0; i + cavity.cap_triangles < cavity.wall.triangles.size(); ++i) {
    const Triangle& t = cavity.wall.triangles[i];
    progress.check();
    share_triangle({cavity.wall.points[t[0]], cavity.wall.points[t[1]], cavity.wall.points[t[2]]}, finest, owners,
                   shapes);
  }
  const std::vector<double> growth = surface_growth(cavity.wall, owners, shapes.size());
  for (std::size_t c = 0; c < shapes.size(); ++c) {
    double area = 0, volume = 0;
    for (const CanalThird& third : shapes[c].thirds) {
      area += third.area;
      volume += third.volume;
    }
    if (area > 0) shapes[c].structure_model_index = 6 * growth[c] * volume / (area * area);
  }
  return shapes;
}

}  // namespace odontoscope
