#pragma once
// Limits of this room, each with its reason.

#include <cstddef>

namespace odontoscope::limits {

/// Bytes of an XML file: parsed it takes several times that. The largest sections of Reconstruct have a few MiB.
inline constexpr std::size_t xml_bytes = 256u << 20;
/// Elements and attributes of it, which take up to 64 bytes each however short they are.
inline constexpr std::size_t xml_parts = 8'000'000;
/// Bytes of a series in JSON, and values in it, which take some 20 bytes each when parsed. Real ones have up to some
/// hundred MiB.
inline constexpr std::size_t jser_bytes = 512u << 20;
inline constexpr std::size_t jser_parts = 60'000'000;
/// Bytes of a structure set, which lies in memory whole: real ones have up to 100 MiB.
inline constexpr std::size_t structure_set_bytes = 1u << 30;
/// How far contours of a structure set that belong to one plane may be apart along its normal, mm: they are written as
/// decimal text of up to 16 characters, and drawn a fraction of a mm apart at least.
inline constexpr double plane_thickness = 1e-3;
/// How far apart they may be, mm, where the planes are ten times as far from each other: numbers rounded on the way
/// through other programs.
inline constexpr double plane_jitter = 0.02;
/// The widest channel of a contour that `--repair` takes for a line drawn there and back, mm, and as a share of the
/// contour's size: what rounding to hundredths leaves, and far below what anybody draws.
inline constexpr double widest_channel = 0.01;
inline constexpr double channel_share = 1e-3;
/// Corners that are looked at for each of a contour while channels are sought; where more crowd together none is.
inline constexpr std::size_t channel_looks = 1000;
/// How far from parallel planes may be, as the sine of the angle: their numbers are rounded to six digits or so.
inline constexpr double out_of_parallel = 1e-5;
/// How far a point may be off its plane, as a share of the least distance of planes: beyond, it is not in the plane
/// that is said.
inline constexpr double off_plane = 0.25;
/// Steps of Newton's method for the inverse of a transform: from a sensible start it takes five or so.
inline constexpr int transform_steps = 50;
/// What is left over when it has converged, over the size of the coordinates.
inline constexpr double transform_rest = 1e-12;

}  // namespace odontoscope::limits
