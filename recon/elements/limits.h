#pragma once
// The tolerances and tuning of elements for simulation, in one place.

#include <cstddef>

namespace odontoscope::elements::limits {

/// The least size that can be asked for, mm.
inline constexpr double least_size = 0.01;
/// Of a material's thickness that an edge may be long.
inline constexpr double size_of_thickness = 0.6;
/// Of the size asked for that none is shorter aimed at.
inline constexpr double least_of_size = 0.15;
/// How much the size may grow along an edge, over the edge's length.
inline constexpr double size_gradient = 0.3;
/// Cosine of the angle to the ray from which a wall counts as turned away from where the ray began.
inline constexpr double facing_cosine = 0.5;

/// Of the aimed size: longer edges are halved, shorter ones collapsed. They are a third of an octave apart, so that
/// halves are not collapsed again.
inline constexpr double longest = 4.0 / 3, shortest = 4.0 / 5;
/// Of the aimed size: how far a new triangle's centre, a new vertex, or a vertex that went may lie off the surface.
inline constexpr double astray = 0.1;
/// Times that the middles of a vertex' triangles are off the surface, by which it is put off it to the other side: its
/// neighbours move as well, and a triangle is off by three quarters of its middle on average. On a ball, volume stays
/// then.
inline constexpr double volume_shift = 1.5;
/// Cosine of the angle by which a triangle may turn in one step.
inline constexpr double turned_cosine = 0.5;
/// Triangles of this quality (1 if equilateral) are good enough to be left alone.
inline constexpr double good_quality = 0.6;
/// What a collapse may make, if nothing worse was there.
inline constexpr double least_quality = 0.25;
inline constexpr double least_gain = 0.02;
inline constexpr int rounds = 8;

/// Elements with a dihedral angle of a smaller sine (15 degrees, or 165) are bad: their corners are moved if that
/// helps, so often, by so much of the mean edge.
inline constexpr double bad_sine = 0.2588;
inline constexpr int improving_passes = 8;
inline constexpr double first_step = 0.4, last_step = 0.02;

/// What TetGen may take: a tooth of a million elements takes some ten seconds and 400 MB.
inline constexpr unsigned fill_seconds = 600, fill_seconds_by_clock = 1800;
inline constexpr std::size_t fill_bytes = std::size_t{8} << 30;
/// Of a regular tetrahedron's volume that the largest may have.
inline constexpr double volume_margin = 1.5;
/// Points on each surface from which the distance to the exact one is measured.
inline constexpr std::size_t distance_samples = 50'000;
/// The suggested size: so many in the diagonal of the smallest material's box; but so few and so many in that of all.
inline constexpr double sizes_in_smallest = 12, fewest_sizes = 15, most_sizes = 60;
/// Sizes that are tried where one changes the topology: each half the one before.
inline constexpr int sizes = 3;

}  // namespace odontoscope::elements::limits
