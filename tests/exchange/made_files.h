#pragma once
// Small files of other programs, made by hand.

#include <string>
#include <vector>

namespace odontoscope::made {

/// A series of Reconstruct: header, and a section with one contour of the given points within a transform.
std::string series(const std::string& units = "mm", const std::string& more = "");
struct Section {
  int index = 1;
  double thickness = 0.5;
  std::string name = "Cell", points = "0 0, 4 0, 4 4, 0 4", closed = "true";
  std::string dimension = "0", xcoef = "0 1 0 0 0 0", ycoef = "0 0 1 0 0 0";
};
std::string section(const Section& what);

/// Two square planes across z at 1 and 3, the upper with a hole.
std::string csl();

/// A structure set (explicit, little-endian) with the given contours.
struct RoiContour {
  std::string data = "0\\0\\1\\4\\0\\1\\4\\4\\1\\0\\4\\1", count = "4", type = "CLOSED_PLANAR";
};
struct RoiOfSet {
  std::string name = "Heart";
  std::vector<RoiContour> contours;
};
std::string rtstruct(const std::vector<RoiOfSet>& rois);
/// The contour data of an axial square.
std::string square(double x, double y, double z, double side);

}  // namespace odontoscope::made
