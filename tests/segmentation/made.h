#pragma once
// Stacks and series that files are written of.

#include <filesystem>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/input/patient_origin.h"
#include "recon/volume/volume.h"
#include "tests/volume/dicom_bytes.h"

namespace odontoscope::made {

using Ring = std::vector<Point2>;

Ring polygon(int corners, double radius, Point2 centre = {}, double first_angle = 0.1);
Ring reversed(Ring ring);

/// Three slices at 0.5, 1.0 and 1.5: a round tooth with two canals (holes), the pulp in them, and an island in a hole
/// of "enamel".
ContourStack tooth();
/// A ring with holes in rows, like a sieve.
std::vector<Ring> sieve(int columns, int rows);

/// Even-odd area of a structure's region in a slice.
double area(const Slice& slice, const std::string& structure);
double signed_area(const Ring& ring);
/// By an odd number of rings around it, in doubles; not for points on them.
bool covers(const std::vector<Ring>& rings, Point2 at);

/// Slices `count` of a CT 12 x 10 pixels of 0.5 x 0.25 mm, 1 mm apart from z = 20 on: a block of 100 in 0. With
/// patient, study and frame of reference.
struct Series {
  int count = 4;
  std::string orientation = "1\\0\\0\\0\\1\\0";
  std::string patient = "Doe^Jane", character_set = {};
  void write(const std::filesystem::path& folder) const;
};

}  // namespace odontoscope::made
