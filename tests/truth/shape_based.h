#pragma once
// Shape-based interpolation, the reference that a reconstruction between slices is held against: in each slice the
// signed distance to the contours in its plane, blended between slices; material is where the blend is negative.
//
// linear: the two slices beside (S. P. Raya and J. K. Udupa, "Shape-based interpolation of multidimensional objects",
// IEEE Transactions on Medical Imaging 9(1), 1990; distances here are Euclidean and exact, G. T. Herman, J. Zheng and
// C. A. Bucholtz, "Shape-based interpolation", IEEE Computer Graphics and Applications 12(3), 1992).
// cubic: Catmull-Rom over four slices, one-sided at the ends of the stack.
//
// A slice without contours has no distance: it counts as outside by the greatest depth of its deeper neighbour, so that
// a shape that ends there ends halfway; it takes no part in a cubic, which would swing.

#include <string>
#include <vector>

#include "plane_raster.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::test {

enum class Blend { linear, cubic };

class ShapeBased {
 public:
  /// One structure of an ordered stack.
  ShapeBased(const ContourStack& stack, const std::string& structure, const Raster& raster);

  /// At `share` (0 to 1) of the way from slice `slab` to the next.
  Mask between(std::size_t slab, double share, Blend blend) const;

  /// Of the whole, by marching cubes on the raster and on layers at most twice its step apart; flat at the stack's
  /// ends.
  SurfaceMesh surface(Blend blend) const;

 private:
  void blend_at(std::size_t slab, double share, Blend blend, double* values) const;
  const double* layer(std::size_t slice) const { return values_.data() + slice * raster_.size(); }
  void fill_empty(const ContourStack& stack, const std::string& structure);

  Raster raster_;
  std::vector<double> heights_;
  std::vector<double> values_;  // slice by slice
  std::vector<bool> empty_;
};

}  // namespace odontoscope::test
