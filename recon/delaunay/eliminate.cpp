#include "recon/delaunay/carve.h"

namespace odontoscope::delaunay {
namespace {

bool stays(const SlabTetrahedron& tet, const Planar& lower, const Planar& upper) {
  if (tet.lower_count == 3) return lower.inside(tet.triangle);
  if (tet.lower_count == 1) return upper.inside(tet.triangle);
  if (tet.lower_edge == EdgeKind::external || tet.upper_edge == EdgeKind::external) return false;
  if (tet.lower_edge == EdgeKind::internal || tet.upper_edge == EdgeKind::internal) return true;
  return tet.dual_in_lower || tet.dual_in_upper;
}

}  // namespace

Fates eliminate(const SlabTetrahedra& tetrahedra, const Planar& lower, const Planar& upper) {
  Fates fate;
  fate.reserve(tetrahedra.size());
  for (const SlabTetrahedron& tet : tetrahedra) fate.push_back(stays(tet, lower, upper) ? Fate::kept : Fate::removed);
  return fate;
}

}  // namespace odontoscope::delaunay
