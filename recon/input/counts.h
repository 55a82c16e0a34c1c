#pragma once
// The limits on how much a stack may hold, for readers (while they read) and for `validate` alike.

#include <cstddef>

#include "recon/core/error.h"

namespace odontoscope {

/// Each throws InputError (too-many-slices, too-many-contours, too-many-points) if `count` is beyond its limit.
void check_slice_count(std::size_t count, const Place& whole_stack);
void check_contours_in_slice(std::size_t count, const Place& slice);
void check_contour_count(std::size_t count, const Place& whole_stack);
void check_point_count(std::size_t count, const Place& whole_stack);

/// Throws InputError not-finite or too-large unless |value| is at most limits::largest_coordinate.
/// `what` names the number in the message: "z", "x".
void check_magnitude(double value, const char* what, const Place& place);

}  // namespace odontoscope
