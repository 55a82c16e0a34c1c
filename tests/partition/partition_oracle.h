#pragma once
// An independent judge of a partition: plain, slow, and without a line of the library's geometry.
//
// What a verdict without faults proves, from the contours and the finished arrays alone:
// - every tetrahedron is positive and within one slab; no two points coincide, none is unused; each face has one or two
// tetrahedra, on opposite
//   sides; each material, and all together, is a PL 3-manifold whose boundary is closed, oriented, edge- and
//   vertex-manifold; the boundary of all together meets itself nowhere and its shells nest, so that with positive
//   tetrahedra no place is covered twice;
// - `interfaces` is exactly the faces between two labels, each once, with the right labels and side out;
// - the solids have the complex's tetrahedra and boundaries, equal to the bit;
// - at each slice the section from above equals that from below; its borders lie on contours, each place has the label
// of the first structure
//   by priority that holds it, each label has the area of its faces in the contours' overlay, and each given point on a
//   visible border is a vertex between just the labels that meet there; no label touches the plane outside its own
//   faces.
//
// What is let pass: `rounding_ulps` units in the last place of the slice's largest coordinate; corners cut where four
// faces or more meet in a point, within `cut_share` of the longest edge there; and void within `gap` of a structure may
// be given to it.

#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/input/contour_stack.h"

namespace odontoscope::test {

inline constexpr double rounding_ulps = 16;
inline constexpr double cut_share = 0.3;

struct PartitionRule {
  std::vector<std::string> priority;  // every structure of the stack, the first wins
  double gap = 0;
};

/// Empty: certified.
std::vector<std::string> partition_faults(const Reconstruction& result, const ContourStack& stack,
                                          const PartitionRule& rule);

/// The part that looks at the slices alone.
std::vector<std::string> section_faults(const LabelledComplex& complex, const ContourStack& stack,
                                        const PartitionRule& rule);

}  // namespace odontoscope::test
