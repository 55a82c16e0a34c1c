#pragma once
// A plane's points on a grid, and which structures' material holds each: the common ground on which truth, surfaces and
// references are compared.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/mesh/meshes.h"

namespace odontoscope::test {

/// Points (x0, y0) + step * (column, row).
struct Raster {
  double x0 = 0, y0 = 0, step = 1;
  std::size_t columns = 0, rows = 0;
  double x(std::size_t column) const { return x0 + step * static_cast<double>(column); }
  double y(std::size_t row) const { return y0 + step * static_cast<double>(row); }
  std::size_t size() const { return columns * rows; }
  std::size_t index(std::size_t column, std::size_t row) const { return row * columns + column; }
};

/// For each point of a raster 1 where there is material, row by row.
using Mask = std::vector<std::uint8_t>;

/// What lies inside an odd number of the structure's contours.
Mask inside_contours(const Raster& raster, const Slice& slice, const std::string& structure);

/// Sections of a closed surface by planes of constant z: what an odd number of its triangles lies below. Parity needs
/// no winding and no repair, so it judges anybody's mesh. Heights ascending.
class SurfaceSections {
 public:
  SurfaceSections(const SurfaceMesh& mesh, const std::vector<double>& heights);
  Mask at(const Raster& raster, std::size_t height) const;

 private:
  const SurfaceMesh& mesh_;
  std::vector<double> heights_;
  std::vector<std::vector<std::uint32_t>> crossing_;  // triangles of each height
};

}  // namespace odontoscope::test
