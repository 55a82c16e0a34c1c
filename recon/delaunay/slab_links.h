#pragma once
// The links of vertices and edges in a slab's triangulation, as far as kept and removed tetrahedra shape them. For
// repair.cpp.

#include <array>
#include <cstdint>
#include <vector>

#include "recon/delaunay/carve.h"
#include "recon/delaunay/shortest_path.h"

namespace odontoscope::delaunay {

class Links {
 public:
  Links(const std::vector<SlabTetrahedron>& tetrahedra, std::size_t points, const std::vector<Fate>& fate);

  bool in(std::uint32_t t) const { return fate_[t] != Fate::removed; }

  /// Other ends of v's edges that have both kept and removed tetrahedra around them, each with one kept tetrahedron on
  /// it.
  std::vector<std::array<std::uint32_t, 2>> mixed_edges(std::uint32_t v);

  /// Around an edge (a, b) of tetrahedron t: the runs of removed tetrahedra between kept ones.
  struct Gaps {
    std::vector<TetList> runs;
    bool closed = false;  // the ring is closed: one run is no singularity. Else its ends lie on the hull or in a slice:
                          // none may be.
    bool singular() const { return runs.size() > (closed ? 1u : 0u); }
    bool closed_and_full() const { return closed && runs.empty(); }
  };
  Gaps gaps(std::uint32_t a, std::uint32_t b, std::uint32_t t) const;

  /// The kept tetrahedra at v, in pieces that are connected through faces at v.
  std::vector<TetList> fans(std::uint32_t v);

  /// The removed tetrahedra at v that are shut in by kept ones: not connected to what lies beyond the hull and the
  /// slices.
  TetList shut_in(std::uint32_t v);

  /// No singular edge at v, one fan, nothing shut in.
  bool regular(std::uint32_t v);

 private:
  void flood(std::uint32_t v, TetList& seeds, bool kept);

  const std::vector<SlabTetrahedron>& tets_;
  const std::vector<Fate>& fate_;
  TetList first_, star_;  // tetrahedra at v: star_[first_[v]] to star_[first_[v+1]]
  std::vector<std::uint32_t> seen_vertex_, seen_tet_;
  std::uint32_t vertex_epoch_ = 0, tet_epoch_ = 0;
};

}  // namespace odontoscope::delaunay
