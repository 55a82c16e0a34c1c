#pragma once
// Small volumes by name, and questions about contours that a test asks again and again.

#include <functional>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/volume/volume.h"

namespace odontoscope::test {

/// Values by a function of the voxel's numbers; spacing 1, origin 0.
Volume volume_of(std::array<std::size_t, 3> size,
                 const std::function<double(std::size_t i, std::size_t j, std::size_t k)>& value);
/// The same rows of digits ("0110") in each of `slices` slices; the first row is y = 0.
Volume volume_of_rows(const std::vector<std::string>& rows, std::size_t slices = 2);
/// Whole numbers below `levels`.
Volume noise(std::uint64_t seed, std::array<std::size_t, 3> size, int levels);

/// Even-odd over the slice's contours of one structure.
bool covers(const Slice& slice, const std::string& structure, Point2 at);
double signed_area(const std::vector<Point2>& ring);
/// Area of the structure's region; relies on outer contours running one way and holes the other.
double region_area(const Slice& slice, const std::string& structure);
const Slice* slice_at(const ContourStack& stack, double z);
/// Of one structure only.
ContourStack only(const ContourStack& stack, const std::string& structure);
/// Empty, or what `validate` and the tests' own check say against the stack.
std::string faults(const ContourStack& stack);

}  // namespace odontoscope::test
