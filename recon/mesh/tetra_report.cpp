#include "recon/mesh/tetra_report.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/mesh/distribution.h"
#include "recon/mesh/exact_predicates.h"
#include "recon/mesh/vector.h"

namespace odontoscope {
namespace {

struct Angles {
  double smallest, largest;  // degrees
};

/// From the outward normals of two faces: they enclose 180 degrees less the angle between the normals. Exact to the
/// last digits for flat angles too, where a cosine is not.
double dihedral(const Direction& n, const Direction& m) {
  return portable::atan2(length(cross(n, m)), -dot(n, m)) * 180 / std::numbers::pi;
}

Angles dihedral_angles(const Direction (&normals)[4]) {
  struct Pair {
    int i = 1, j = 0;
    double cosine = 0;
  };
  Pair sharpest, bluntest;
  sharpest.cosine = -2;
  bluntest.cosine = 2;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      const double lengths = std::sqrt(dot(normals[i], normals[i]) * dot(normals[j], normals[j]));
      if (!(lengths > 0)) return {0, 180};  // a face without area: as flat as can be
      const double cosine = -dot(normals[i], normals[j]) / lengths;
      if (cosine > sharpest.cosine) sharpest = {i, j, cosine};
      if (cosine < bluntest.cosine) bluntest = {i, j, cosine};
    }
  }
  return {dihedral(normals[sharpest.i], normals[sharpest.j]), dihedral(normals[bluntest.i], normals[bluntest.j])};
}

double bounded(double ratio) { return ratio < limits::largest_aspect_ratio ? ratio : limits::largest_aspect_ratio; }

/// Measurements of all elements, and sums that are added chunk by chunk so that threads do not matter.
struct Measurements {
  std::vector<double> smallest, largest, radius, radius_edge;
  std::vector<double> volume_of_chunk;
  std::vector<std::size_t> non_positive_of_chunk;

  explicit Measurements(std::size_t elements, std::size_t chunks)
      : smallest(elements),
        largest(elements),
        radius(elements),
        radius_edge(elements),
        volume_of_chunk(chunks),
        non_positive_of_chunk(chunks) {}
};

/// Six times the volume.
double measure(const TetraMesh& mesh, std::size_t element, Measurements& into) {
  const auto [ia, ib, ic, id] = mesh.tetrahedra[element];
  const Point3 &a = mesh.points[ia], &b = mesh.points[ib], &c = mesh.points[ic], &d = mesh.points[id];
  const Direction ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  const Direction acd = cross(ac, ad), adb = cross(ad, ab), abc = cross(ab, ac);
  const Direction bcd = cross(bc, bd);
  const Angles angles = dihedral_angles({bcd, -1.0 * acd, -1.0 * adb, -1.0 * abc});
  into.smallest[element] = angles.smallest;
  into.largest[element] = angles.largest;

  const double six_volumes = dot(ab, acd);
  const Direction centre = dot(ab, ab) * acd + dot(ac, ac) * adb + dot(ad, ad) * abc;  // from a, times 2 * six_volumes
  const double shortest = std::min({dot(ab, ab), dot(ac, ac), dot(ad, ad), dot(bc, bc), dot(bd, bd), dot(cd, cd)});
  // Inscribed: three volumes over the area of all faces, that is six volumes over twice that area.
  const double areas = length(bcd) + length(acd) + length(adb) + length(abc), around = length(centre);
  into.radius[element] =
      areas > 0 && around > 0 ? 3 * std::abs(six_volumes) / areas * (2 * std::abs(six_volumes) / around) : 0;
  into.radius_edge[element] = bounded(length(centre) / (2 * std::abs(six_volumes) * std::sqrt(shortest)));
  return six_volumes;
}

void measure_chunk(const TetraMesh& mesh, std::size_t chunk, std::size_t chunk_size, Measurements& into) {
  double six_volumes = 0;
  std::size_t non_positive = 0;
  const std::size_t last = std::min(mesh.tetrahedra.size(), (chunk + 1) * chunk_size);
  for (std::size_t element = chunk * chunk_size; element < last; ++element) {
    six_volumes += measure(mesh, element, into);
    const auto [a, b, c, d] = mesh.tetrahedra[element];
    non_positive += orientation(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) <= 0;
  }
  into.volume_of_chunk[chunk] = six_volumes / 6;
  into.non_positive_of_chunk[chunk] = non_positive;
}

}  // namespace

TetraReport inspect(const TetraMesh& mesh) {
  constexpr std::size_t chunk_size = 4096;
  const std::size_t chunks = (mesh.tetrahedra.size() + chunk_size - 1) / chunk_size;
  Measurements measured(mesh.tetrahedra.size(), chunks);
  tbb::parallel_for(std::size_t{0}, chunks,
                    [&](std::size_t chunk) { measure_chunk(mesh, chunk, chunk_size, measured); });

  TetraReport report;
  report.tetrahedra = mesh.tetrahedra.size();
  for (const double volume : measured.volume_of_chunk) report.volume += volume;
  for (const std::size_t count : measured.non_positive_of_chunk) report.non_positive += count;
  report.smallest_dihedral_deg = distribution_of(measured.smallest, 0, limits::dihedral_histogram_high);
  report.largest_dihedral_deg = distribution_of(measured.largest, 0, limits::dihedral_histogram_high);
  report.radius_ratio = distribution_of(measured.radius, 0, 1);
  report.radius_edge_ratio = distribution_of(measured.radius_edge, 0, limits::radius_edge_histogram_high);
  return report;
}

}  // namespace odontoscope
