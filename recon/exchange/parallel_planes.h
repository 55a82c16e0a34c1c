#pragma once
// Closed lines in space, told to be planar, put together to the slices of parallel planes. Inner part of
// read_rtstruct.h.

#include <string>
#include <vector>

#include "recon/core/error.h"
#include "recon/exchange/contour_file.h"

namespace odontoscope {

/// A contour in space, not yet in a plane.
struct Outline {
  std::string structure;
  std::size_t number = 0;  // within its structure, for messages
  std::vector<Point3> points;
};

/// Planes across an axis keep their numbers: across z (x and y stay), x (y, z, x) or y (z, x, y); any others are read
/// in a frame of their own, plane_frame.h, of the normal that all outlines have together. Points are projected onto
/// their plane.
///   - An outline may leave its plane by limits::plane_jitter.
///   - Outlines within limits::plane_jitter of each other along the normal are one plane, unless the true planes lie so
///   close that this is no tenth of
///     their distance; then limits::plane_thickness holds. The slice has the height that most of its outlines have.
/// Slices come by ascending height; within them, outlines in their order. What was assumed is added to `remarks`.
/// Throws InputError not-parallel, and the counts of counts.h; `whole` is the place of them all. `frame` is how the
/// slices lie among the outlines.
std::vector<Slice> slices_of(const std::vector<Outline>& outlines, const Place& whole,
                             std::vector<std::string>& remarks, PatientFrame& frame);

}  // namespace odontoscope
