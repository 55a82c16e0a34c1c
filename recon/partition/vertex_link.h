#pragma once
// The link of one vertex in a labelled complex of tetrahedra: is every label's part of it a disc, and if not, what is
// in the way?
//
// What no tetrahedron fills is void. A label's solid is a manifold with boundary at the vertex exactly if its part of
// the link is a disc, or the whole sphere; so it must be for each material and for all materials together.

#include <array>
#include <cstdint>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope::partition {

struct LinkTriangle {
  std::array<std::uint32_t, 3> v{};
  Label label = void_label;
  std::uint32_t cell = 0;  // whatever the caller knows the tetrahedron by
};

/// Cells that would have to change their label, and to which.
struct Mend {
  std::vector<std::uint32_t> cells;
  Label label = void_label;
};

class VertexLink {
 public:
  explicit VertexLink(std::vector<LinkTriangle> triangles);

  bool regular() const;

  /// Ways to make the first irregular part better: give away a piece of it, or fill what parts it; without any that
  /// would change a cell that `fixed` says must stay. Fewest cells first, then the lowest. Empty: there is none.
  template <class Fixed>
  std::vector<Mend> mends(Fixed fixed) const {
    std::vector<Mend> found;
    for (Mend& mend : all_mends()) {
      bool possible = true;
      for (const std::uint32_t cell : mend.cells) possible = possible && !fixed(cell);
      if (possible) found.push_back(std::move(mend));
    }
    return found;
  }

 private:
  /// A set of triangles: those of one label, or those of all materials together.
  struct Part {
    bool materials = false;
    Label label = void_label;
    bool has(Label other) const { return materials ? other != void_label : other == label; }
  };

  /// What lies beyond edges with one triangle: no part of any piece, or one that joins all that reach it.
  enum class Outside { apart, joins };
  enum class Among { all, materials };

  std::vector<Part> parts() const;
  bool is_disc(const Part& part) const;
  std::vector<Mend> all_mends() const;
  std::vector<std::vector<std::uint32_t>> pieces(const std::vector<bool>& in, Outside outside,
                                                 std::vector<bool>& touches_outside) const;
  Label commonest_beside(const std::vector<std::uint32_t>& piece, Among among) const;
  void number_corners();
  void match_edges();

  std::vector<LinkTriangle> triangles_;
  std::vector<std::array<std::uint16_t, 3>> corners_;  // of each triangle: numbers of link vertices from 0
  std::size_t vertices_ = 0;
  std::vector<std::array<std::uint32_t, 3>> across_;  // across the edge opposite v[i]; none: nothing there
};

}  // namespace odontoscope::partition
