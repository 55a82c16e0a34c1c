#pragma once
// Contours that go into their own region along one line and come back beside it, a few micrometres off: a hole that was
// drawn in one line with its outside, of which rounding has left a channel. Inner part of repair_contours.h.

#include <optional>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

struct ClosedChannel {
  std::vector<Point2> points;  // runs along the channel there and back through the very same points
  double width = 0;            // the widest that was closed
};

/// Where two parts of the contour that are far from each other along it have less than a width between them, with
/// outside in between, they are moved together, if that shuts in a hole which is wide over against the channel: a notch
/// stays. The width is limits::widest_channel, or limits::channel_share of the contour's size where that is less.
/// Nothing if there is no such place; then, and also where points are too crowded to be looked through, the contour is
/// as good as it is. Precondition: finite; neighbours differ.
std::optional<ClosedChannel> close_channels(const std::vector<Point2>& contour);

}  // namespace odontoscope
