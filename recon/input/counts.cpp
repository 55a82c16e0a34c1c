#include "recon/input/counts.h"

#include <fmt/format.h>

#include <cmath>

#include "recon/core/limits.h"

namespace odontoscope {
namespace {

constexpr std::string_view split = "Thin the stack out, or split it into parts";

}  // namespace

void check_slice_count(std::size_t count, const Place& whole_stack) {
  if (count <= limits::slices) return;
  throw InputError("too-many-slices", whole_stack, fmt::format("more than {} slices", limits::slices), split);
}

void check_contours_in_slice(std::size_t count, const Place& slice) {
  if (count <= limits::contours_per_slice) return;
  throw InputError("too-many-contours", slice,
                   fmt::format("more than {} contours in one slice", limits::contours_per_slice),
                   "Drop the smallest ones, or smooth the image that they come from");
}

void check_contour_count(std::size_t count, const Place& whole_stack) {
  if (count <= limits::contours) return;
  throw InputError("too-many-contours", whole_stack, fmt::format("more than {} contours", limits::contours), split);
}

void check_point_count(std::size_t count, const Place& whole_stack) {
  if (count <= limits::points) return;
  throw InputError("too-many-points", whole_stack, fmt::format("more than {} points", limits::points), split);
}

void check_magnitude(double value, const char* what, const Place& place) {
  if (std::abs(value) <= limits::largest_coordinate) return;
  if (!std::isfinite(value)) {
    throw InputError("not-finite", place, fmt::format("{} is {}, which is no number", what, value),
                     "Find out where the number was lost, or leave the point out");
  }
  throw InputError("too-large", place,
                   fmt::format("{} = {} mm lies beyond {} mm", what, value, limits::largest_coordinate),
                   "Check the unit");
}

}  // namespace odontoscope
