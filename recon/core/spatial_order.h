#pragma once
// In which order points are inserted into a triangulation.

#include <cstdint>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

/// Neighbours in turn, which is fast to insert: rounds of the points, each about four times the one before (N. Amenta,
/// S. Choi and G. Rote, Incremental Constructions con BRIO, 2003), in each of them along a curve that fills the plane
/// (D. Hilbert's) or space (G. M. Morton's). Depends on the places alone, not on how the points are numbered (but of
/// equal points the lower number comes first), so that a triangulation of points on one circle does not either; and not
/// on the compiler's library. Precondition: all are finite, fewer than 2^32.
std::vector<std::uint32_t> spatial_order(const std::vector<Point2>& points);
std::vector<std::uint32_t> spatial_order(const std::vector<Point3>& points);

}  // namespace odontoscope
