#include "recon/radiograph/length_inside.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "recon/core/error.h"
#include "recon/radiograph/film_vector.h"

namespace odontoscope {

using namespace radiograph;

namespace {

/// A corner on the film, x to the right and y upwards from the lower left corner.
struct Projected {
  double x = 0, y = 0;  // pixels
  /// What runs straight over a projected triangle: of a parallel beam the distance along the ray from the film's plane,
  /// negative before it; of a cone the film's distance from the focus over the corner's.
  double depth = 0;
};

/// On whole numbers. Products of two differences of such numbers fit 62 bits.
struct Fixed {
  std::int64_t x = 0, y = 0;
};
constexpr double most_fixed = 1 << 29;
constexpr int most_bits = 16, least_bits = 8;

struct Face {
  std::array<Fixed, 3> corner;  // counter-clockwise on the film
  std::array<double, 3> depth{};
  double sign = 1;  // -1 where a ray enters
  std::int64_t twice_area = 0;
};

class Projection {
 public:
  explicit Projection(const FilmView& view) : view_(view), normal_(view.towards_viewer()) {
    cone_ = view.beam == FilmView::Beam::cone;
    film_ = cone_ ? dot(minus(view.focus, view.centre), normal_) : 0;
  }

  Projected operator()(const Point3& point) const {
    if (!cone_) {
      const double way =
          dot(minus(view_.centre, point), normal_) / dot(view_.towards_tube, normal_);  // negative: before the film
      return on_film(plus(point, times(way, view_.towards_tube)), way);
    }
    const double before = dot(minus(view_.focus, point), normal_);
    if (!(before > film_ * least_distance))
      throw UsageError("the tube stands within or behind what it shines through", "Move it away with --focus MM.");
    const double scale = film_ / before;
    return on_film(plus(view_.focus, times(scale, minus(point, view_.focus))), scale);
  }

 private:
  static constexpr double least_distance =
      1e-3;  // over the film's: nearer a corner's shadow would be thousands of times as large as itself

  Projected on_film(const Point3& place, double depth) const {
    const Point3 way = minus(place, view_.centre);
    return {dot(way, view_.right) / view_.pixel + 0.5 * view_.columns,
            dot(way, view_.up) / view_.pixel + 0.5 * view_.rows, depth};
  }

  const FilmView& view_;
  Point3 normal_;
  double film_ = 0;
  bool cone_ = false;
};

std::int64_t turn(const Fixed& a, const Fixed& b, const Fixed& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Fractions of a pixel, as a power of two, that fit the farthest corner.
int bits_for(const std::vector<std::vector<Projected>>& corners) {
  double farthest = 1;
  for (const auto& surface : corners)
    for (const Projected& corner : surface) farthest = std::max({farthest, std::abs(corner.x), std::abs(corner.y)});
  int bits = most_bits;
  while (bits >= least_bits && !(farthest * std::ldexp(1.0, bits) < most_fixed)) --bits;
  if (bits < least_bits)
    throw UsageError("the solid spans more than a million pixels of the film", "Give larger pixels with --pixel MM.");
  return bits;
}

std::vector<Face> faces_of(std::span<const SurfaceMesh* const> surfaces, const FilmView& view, int& bits) {
  const Projection project(view);
  std::vector<std::vector<Projected>> corners;
  for (const SurfaceMesh* surface : surfaces) {
    corners.emplace_back();
    for (const Point3& point : surface->points) corners.back().push_back(project(point));
  }
  bits = bits_for(corners);
  const double unit = std::ldexp(1.0, bits);
  std::vector<Face> faces;
  for (std::size_t s = 0; s < corners.size(); ++s)
    for (const Triangle& triangle : surfaces[s]->triangles) {
      Face face;
      for (std::size_t i = 0; i < 3; ++i) {
        const Projected& corner = corners[s][triangle[i]];
        face.corner[i] = {std::llround(corner.x * unit), std::llround(corner.y * unit)};
        face.depth[i] = corner.depth;
      }
      face.twice_area = turn(face.corner[0], face.corner[1], face.corner[2]);
      if (face.twice_area == 0) continue;  // seen edge-on: covers no pixel, and its neighbours meet beyond it
      face.sign = face.twice_area > 0 ? -1 : 1;
      if (face.twice_area < 0) {
        std::swap(face.corner[1], face.corner[2]);
        std::swap(face.depth[1], face.depth[2]);
        face.twice_area = -face.twice_area;
      }
      faces.push_back(face);
    }
  return faces;
}

/// Does a pixel's centre that lies on the edge belong to the triangle on its left?
bool owns(const Fixed& from, const Fixed& to) { return to.y < from.y || (to.y == from.y && to.x < from.x); }

/// Pixels are counted from the lower left corner here.
class Band {
 public:
  Band(const FilmView& view, int bits, int first, int last, FilmMap& map)
      : view_(view), bits_(bits), first_(first), last_(last), map_(map) {}

  void add(const Face& face) {
    const auto [low_x, high_x] = std::minmax({face.corner[0].x, face.corner[1].x, face.corner[2].x});
    const auto [low_y, high_y] = std::minmax({face.corner[0].y, face.corner[1].y, face.corner[2].y});
    const std::int64_t left = std::max<std::int64_t>(low_x >> bits_, 0),
                       right = std::min<std::int64_t>(high_x >> bits_, view_.columns - 1);
    const std::int64_t bottom = std::max<std::int64_t>(low_y >> bits_, first_),
                       top = std::min<std::int64_t>(high_y >> bits_, last_);
    for (std::int64_t y = bottom; y <= top; ++y)
      for (std::int64_t x = left; x <= right; ++x) add(face, x, y);
  }

 private:
  void add(const Face& face, std::int64_t x, std::int64_t y) {
    const std::int64_t half = std::int64_t{1} << (bits_ - 1);
    const Fixed centre{(x << bits_) + half, (y << bits_) + half};
    double depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Fixed &from = face.corner[(i + 1) % 3], &to = face.corner[(i + 2) % 3];
      const std::int64_t weight = turn(from, to, centre);
      if (weight < 0 || (weight == 0 && !owns(from, to))) return;
      depth += static_cast<double>(weight) * face.depth[i];
    }
    depth /= static_cast<double>(face.twice_area);
    const int column = static_cast<int>(x), row = view_.rows - 1 - static_cast<int>(y);
    // Of a cone: from the focus the ray has gone 1 / depth of its way to the film.
    if (view_.beam == FilmView::Beam::cone) depth = (1 / depth - 1) * ray_to(view_, column, row).length;
    map_.at(column, row) += face.sign * depth;
  }

  const FilmView& view_;
  int bits_, first_, last_;
  FilmMap& map_;
};

constexpr int band_rows = 16;

}  // namespace

FilmMap length_inside(std::span<const SurfaceMesh* const> surfaces, const FilmView& view, const Progress& progress) {
  FilmMap map{view.columns, view.rows,
              std::vector<double>(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows))};
  int bits = 0;
  const std::vector<Face> faces = faces_of(surfaces, view, bits);
  const int bands = (view.rows + band_rows - 1) / band_rows;
  std::vector<std::vector<std::uint32_t>> in_band(static_cast<std::size_t>(bands));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [low, high] = std::minmax({faces[f].corner[0].y, faces[f].corner[1].y, faces[f].corner[2].y});
    const std::int64_t first = std::max<std::int64_t>((low >> bits) / band_rows, 0),
                       last = std::min<std::int64_t>((high >> bits) / band_rows, bands - 1);
    for (std::int64_t band = first; band <= last && (high >> bits) >= 0; ++band)
      in_band[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(f));
  }
  tbb::parallel_for(0, bands, [&](int number) {
    if (progress.stop.stop_requested()) return;
    Band band(view, bits, number * band_rows, std::min((number + 1) * band_rows, view.rows) - 1, map);
    for (const std::uint32_t face : in_band[static_cast<std::size_t>(number)]) band.add(faces[face]);
  });
  progress.check();
  return map;
}

}  // namespace odontoscope
