#pragma once
// Contours at heights between two given slices of one structure: virtual slices, for slabs in which a triangulation of
// the two slices alone guesses badly (flat roofs, thin walls that drift, slanted canals).
//
// Shape-based interpolation: each slice's signed in-plane distances, blended, and the zero set traced (G. T. Herman,
// J. Zheng, C. A. Bucholtz, "Shape-based interpolation", IEEE CG&A 12(3), 1992; S. P. Raya, J. K. Udupa, IEEE TMI 9(1),
// 1990), here
// - cubic over four slices at their true heights (Catmull-Rom; a parabola where one neighbour is missing or unlike,
//   a straight line where both are);
//   how far it bends is bounded where the slices beyond the slab disagree;
// - contour by contour: what the links join one to one is blended as a filled shape of its own, and the shapes are put
//   together afterwards, outer contours minus holes. So a ring that drifts by more than its width stays a ring;
// - with motion: linked shapes that hardly overlap are moved (and scaled) onto each other before they are blended, on a
//   smooth path through all four slices. So a slanted canal stays a canal. Shapes that overlap well are not moved.
// Contours that merge or split are blended as a union; a region or hole with no partner ends where its course beyond
// the slab says; where that says nothing, it shrinks against the distance to the other slice's nearest contour.
//
// Units are millimetres. Same input, same bytes. Not thread-parallel by itself; slabs are independent of each other.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope::between {

/// One structure in one slice: closed, simple, pairwise disjoint contours, outer ones counter-clockwise, holes
/// clockwise, as `ordered` (recon/input/validate.h) gives them.
using Outline = std::vector<std::vector<Point2>>;

/// In a link of voids: the unbounded void around everything.
inline constexpr std::size_t outside = std::numeric_limits<std::size_t>::max();

/// Numbers of contours in the lower and in the upper outline.
struct ContourLink {
  std::size_t lower = 0, upper = 0;
  friend bool operator==(const ContourLink&, const ContourLink&) = default;
};

/// The slab and what lies beyond it. Heights ascend strictly.
struct Surroundings {
  const Outline* before = nullptr;  // the slice below `lower`, if there is one
  const Outline* lower = nullptr;
  const Outline* upper = nullptr;
  const Outline* after = nullptr;  // the slice above `upper`, if there is one
  double z_before = 0, z_lower = 0, z_upper = 0, z_after = 0;
  /// Regions that are joined, by their outer contours.
  std::vector<ContourLink> material;
  /// Void regions that are joined, by their hole contours, or `outside` for the unbounded one. That lower and upper
  /// outside are joined goes without saying.
  std::vector<ContourLink> voids;
};

struct BlendOptions {
  /// How far thinning may move a contour, over the larger side of the slab's bounding box: 0.002 mm for a tooth of
  /// 10 mm.
  double thinning = 2e-4;
  /// Largest number of grid points. The step follows from the narrowest contour and wall; this bounds time and memory.
  std::size_t most_grid_points = 90'000;
  /// What juts out as a strip (the end of an open ring, a groove) grows along its length. Without, distances alone
  /// decide.
  bool strips = true;
  /// Grid points for each one along either side; `most_grid_points` grows with it. For walls thinner than a step.
  std::size_t finer = 1;
  /// Passages and walls a step of the grid wide are put where slices join what links keep apart, or part what they join
  /// (kept_links.h). The shares' slices then depend on each other.
  bool keep_links = false;
  /// More slices than asked for, between those where a lobe would vanish all at once (drawn_back.h).
  bool draw_back = false;
};

/// An outline at a share of the slab's height.
struct StagedOutline {
  double share = 0;
  Outline outline;
};

/// Outlines at z_lower + share * (z_upper - z_lower) for each share, in the same order. Contours are closed, simple and
/// disjoint, outer ones counter-clockwise, holes clockwise, ordered by their lowest point; coordinates are multiples of
/// a power of two (2^-30 mm for a tooth). Where the slices are too small for their distance from the origin to be
/// sampled, the nearer one is returned as it is.
///
/// Preconditions, checked (InternalError): lower and upper are given, heights finite and ascending, shares in (0, 1)
/// and ascending, links name outer contours and holes respectively.
///
/// Not promised: that the outlines have the topology that the links imply. Walls thinner than a step of the grid may
/// break.
std::vector<Outline> blend(const Surroundings& surroundings, std::span<const double> shares,
                           const BlendOptions& options = {});

/// The same with their shares: those given, and with options.draw_back others between them. The same preconditions.
std::vector<StagedOutline> blend_in_stages(const Surroundings& surroundings, std::span<const double> shares,
                                           const BlendOptions& options = {});

/// How much there is to guess in a slab.
struct SlabNeed {
  /// Width of the widest place where one slice has material and the other has not: how far the surface travels
  /// sideways within the slab, mm.
  double travel = 0;
  /// Area of all such places, mm^2.
  double area = 0;
};

/// Measured on a grid of at most `most_grid_points`, to about a step of it. 0 for two empty outlines, and
/// where areas of their size are no numbers any more (denormal).
SlabNeed need(const Outline& lower, const Outline& upper, std::size_t most_grid_points = 20'000);

}  // namespace odontoscope::between
