#pragma once
// A stack of planar contours: what every reconstruction starts from. A plain value; the file format that mirrors it
// is described in docs/formats.md.
//
// Units are millimetres. A contour is a closed, simple polygon; the last point joins the first and is not repeated. The
// region of a structure in a slice is what lies inside an odd number of that structure's contours, so orientation on
// input does not matter. Contours of one structure neither cross nor touch; those of different structures may.
// `validate` (validate.h) checks all of this; everything behind it relies on it.

#include <string>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

struct Contour {
  std::string structure = "tooth";
  std::vector<Point2> points;
};

struct Slice {
  double z = 0;
  std::vector<Contour> contours;
};

struct ContourStack {
  std::vector<Slice> slices;
  /// Name of the file it came from, for messages; may be empty.
  std::string source;
};

}  // namespace odontoscope
