#pragma once
// The regions of one structure, or its voids, through all slices, joined by the links that were made: which pieces
// there are, where they end, and which ends face each other across a slab.

#include <optional>
#include <string>
#include <vector>

#include "recon/core/polygon.h"
#include "recon/core/union_find.h"
#include "recon/delaunay/reconstruct.h"

namespace odontoscope::delaunay {

/// A region, by its outer contour, or a void, by the contour of the hole.
struct Section {
  std::size_t slice = 0, contour = 0;  // number in the slice's list
  const Polygon* ring = nullptr;
  double area = 0;  // within the ring
  Point2 centre;
  bool linked_below = false, linked_above = false;
  double area_below = 0, area_above = 0;  // of what it is linked with
  bool open = false;  // of a void: it goes on to the outside, or lies in a slice at an end of the stack
};

/// Two sections on neighbouring slices, of different pieces, that face each other: at least one of them ends here.
struct FacingEnds {
  std::size_t lower = 0, upper = 0;  // sections
  double gap = 0;                    // of their contours seen from above, mm; 0: they overlap
  double aside = 0;                  // distance of their centres seen from above, mm
};

class Strands {
 public:
  enum class Of { material, voids };
  /// Keeps references to the contours of `ordered`.
  Strands(const Reconstruction& made, const ContourStack& ordered, const std::string& structure, Of what);

  const std::vector<Section>& sections() const { return sections_; }
  std::uint32_t piece(std::size_t section) { return pieces_.find(static_cast<std::uint32_t>(section)); }

  /// Groups of pairs that have ends in common, the nearest pair first in each; by slice. Two ends face each other if
  /// they overlap, or are no farther apart than limits::facing_gap times the width of the smaller; an end and what goes
  /// on, if they overlap; but not the end of a void that is running out, as the bottom of a fissure over the dentine.
  std::vector<std::vector<FacingEnds>> facing(const std::vector<Link>& links);

 private:
  std::optional<std::size_t> number(std::size_t slice, std::size_t contour) const;
  void join(std::size_t slice, std::optional<std::size_t> lower, std::optional<std::size_t> upper);
  enum class Towards { below, above };
  bool runs_out(const Section& section, Towards next) const;
  void face_in_slab(std::size_t slice, const std::vector<Link>& apart, std::vector<FacingEnds>& found);

  Of what_;
  std::vector<double> heights_;     // of the slices
  std::vector<Section> sections_;   // by slice, then contour
  std::vector<std::size_t> first_;  // of each slice; one more than there are slices
  UnionFind pieces_{0};
};

}  // namespace odontoscope::delaunay
