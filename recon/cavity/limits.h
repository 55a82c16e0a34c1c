#pragma once
// Every bound of this room, each with its reason. All but known_end are shares of the shape itself, so that a tooth in
// voxels and one in millimetres are treated alike.

#include <cstddef>

namespace odontoscope::limits {

/// A cavity with less than this share of the largest one's volume is a speck: noise of a scan, a bubble between slices.
inline constexpr double cavity_speck = 1e-3;
/// An open canal is at least this many times as deep, along z, as its widest mouth is wide: the dip between a tooth's
/// cusps is not.
inline constexpr double pocket_depth = 2;
/// Planes of constant z in which open canals are looked for, but for the two ends.
inline constexpr std::size_t pocket_levels = 100;
/// A cap at the very end of a surface lies this share of the surface's height inside, where it cuts walls and not the
/// end itself.
inline constexpr double cap_inset = 1e-3;
/// The chamber is what balls of at least this share of the widest one's radius fill.
inline constexpr double chamber_share = 0.5;
/// A void with two ends whose widest place is no more than this many times as wide as its median has no chamber.
inline constexpr double chamber_over_tube = 1.5;
/// Where both ends are farther from its widest place than so many of its radii, it is enough that it is so many times
/// as wide: a taper is widest at an end.
inline constexpr double chamber_arms = 3, chamber_over_arms = 1.2;
/// A way that leaves the chamber for no more than this share of its radius, and leads aside from the longest one (the
/// cosine between them is above minus so much), is a lobe of a flat chamber.
inline constexpr double lobe_tip = 0.5, lobe_aside = 0.5;
/// A branch of the void counts if it protrudes from what is known by this many times its own mean radius: a corner of
/// the chamber or a bump of a scan protrudes by about one.
inline constexpr double branch_slenderness = 2.5;
/// A branch protrudes by at least this share of the one that protrudes most.
inline constexpr double branch_share = 0.06;
/// And by more than the ball where it branches off, which reaches to the wall anyway.
inline constexpr double branch_over_root = 1.2;
/// Its mean radius is at least this share of the first one's: what is thinner lies in a crease of the wall.
inline constexpr double branch_width = 0.1;
/// Both sides of a handle that counts are everywhere at least this share as wide as what leads to the void's farthest
/// place.
inline constexpr double handle_width = 0.5;
/// Canals that join at an acute angle share a wide place this many radii long.
inline constexpr double join_reach = 5;
/// A canal is at least this share as long as the longest one, from the chamber on; shorter branches are `others`.
inline constexpr double canal_share = 0.25;
/// A shorter one is a canal all the same if it runs towards the apex beside another one with material in between, so
/// many times its mean width long, and is this share as wide as the canal that it leaves. The tip of a fin is neither.
inline constexpr double fork_length = 2, fork_width = 0.5;
/// A connection of two canals up to this share as wide as the narrower one is hair-thin; a canal extends towards
/// another one if it reaches so many radii from its middle.
inline constexpr double isthmus_thin = 0.25, isthmus_reach = 2;
/// Two canals whose connection is this share as wide as the narrower one are one section; what is narrower is an
/// isthmus between two.
inline constexpr double isthmus_wide = 0.75;
/// Round each point of a found branch, what lies within this many times the radius there belongs to it.
inline constexpr double branch_cover = 1.6;
/// A tip that reaches farther ahead than the ball before it by less than this share of that ball's radius adds nothing
/// but a corner.
inline constexpr double tip_reach = 0.2;
/// Canals whose lines are nearer to each other than this share of the radius run together.
inline constexpr double together = 0.5;
/// A line goes on straight beyond its last such ball, towards the wall, as long as it keeps this share of that ball's
/// radius.
inline constexpr double tip_clearance = 0.35;
/// Where clearance falls by more than this a millimetre towards a blind end, the way leads into a corner: a taper that
/// steep, 33 degrees, would be no canal.
inline constexpr double corner_fall = 0.3;
/// It ends where the void has closed to a gap of this share of the widest ball within three median radii before.
inline constexpr double tip_gap = 0.2;
/// A canal begins where the section across its line shrinks most within one radius, if by this factor or more.
inline constexpr double orifice_drop = 1.5;
/// Nearer to its orifice than this share of its radius a canal's wall is as much the chamber's.
inline constexpr double orifice_rim = 0.5;
/// Within a radius below it, a wall that faces along the canal, its normal at less than 45 degrees from the line, is
/// the chamber's floor.
inline constexpr double floor_cosine = 0.7;
/// Of several such places the last one whose drop, as a logarithm, is this share of the greatest.
inline constexpr double orifice_great = 0.6;
/// It is looked for in this first part of a line.
inline constexpr double orifice_part = 0.6;
/// Sections are measured as far as this many radii of the chamber.
inline constexpr double section_reach = 2.5;
/// The wall is sampled so finely that this many points would do, if they were evenly spread; vertices closer than that
/// are all taken. Flat floors have vertices on their rims only.
inline constexpr double wall_samples = 4000;
/// Where smoothing would leave less than this share of the clearance that a point had, it is not smoothed.
inline constexpr double line_share = 0.96;
/// Widest balls are found to this share of their radius: what is missed shows in every width.
inline constexpr double ball_fineness = 0.001;
/// What moving a ball costs while its width is looked for: the square of the way in radii times this share of its
/// radius, so that it stays in its canal.
inline constexpr double ball_pull = 0.02;
/// How near to its known end a sample tooth's canal must end to be taken for it, mm: a slice's spacing and a little
/// more.
inline constexpr double known_end = 0.6;
/// Distance of a line's points, over its median radius, and the most points of a line.
inline constexpr double line_step = 0.25;
inline constexpr std::size_t line_points = 4000;
/// What is no farther from the outside than this share of the tooth's size touches it: coordinates in single precision
/// differ by less.
inline constexpr double opening = 1e-6;
/// A tooth is measured along its own axis if its mass is spread so many times as far along it as across, and it leans
/// by more than this: roots spread to one side turn an upright tooth's axis by some degrees.
inline constexpr double axis_ratio = 1.25, axis_tilt_deg = 10;
/// A bend is told of stretches at least this many mean widths long.
inline constexpr double bend_stretch = 2;
/// A line is known to this many times what short stretches are off their circles, within these shares of the mean
/// width.
inline constexpr double bend_noise = 4, bend_finest = 0.005, bend_coarsest = 0.03;
/// What bows no more than this many times as much is straight.
inline constexpr double bend_bow = 5;
/// A section is compact if it fills this share of its convex hull (polygons of a noisy scan fill less than all of it),
/// and is no larger than so many squares of its widest ball's radius: an ellipse five times as wide as thick is.
inline constexpr double section_solidity = 0.95, section_flatness = 16;
/// All stretches of so many points are tried: some ten thousand.
inline constexpr std::size_t bend_points = 160;

}  // namespace odontoscope::limits
