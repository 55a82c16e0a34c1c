#pragma once
// The links of vertices and edges in a slab's triangulation, as far as kept and removed tetrahedra shape them. For
// repair.cpp.

#include <array>
#include <cstdint>
#include <vector>

#include "recon/core/index_groups.h"
#include "recon/delaunay/carve.h"
#include "recon/delaunay/shortest_path.h"

namespace odontoscope::delaunay {

class Links {
 public:
  Links(const SlabTetrahedra& tetrahedra, std::size_t points, const Fates& fate);

  bool in(TetIndex t) const { return fate_[t] != Fate::removed; }

  /// Other ends of v's edges that have both kept and removed tetrahedra around them, each with one kept tetrahedron on
  /// it.
  struct MixedEdge {
    SlabPoint end;
    TetIndex kept;
  };
  std::vector<MixedEdge> mixed_edges(SlabPoint v);

  /// Around an edge (a, b) of tetrahedron t: the runs of removed tetrahedra between kept ones.
  struct Gaps {
    std::vector<TetList> runs;
    bool closed = false;  // the ring is closed: one run is no singularity. Else its ends lie on the hull or in a slice:
                          // none may be.
    bool singular() const { return runs.size() > (closed ? 1u : 0u); }
    bool closed_and_full() const { return closed && runs.empty(); }
  };
  Gaps gaps(SlabPoint a, SlabPoint b, TetIndex t) const;

  /// The kept tetrahedra at v, in pieces that are connected through faces at v.
  std::vector<TetList> fans(SlabPoint v);

  /// The removed tetrahedra at v that are shut in by kept ones: not connected to what lies beyond the hull and the
  /// slices.
  TetList shut_in(SlabPoint v);

  /// No singular edge at v, one fan, nothing shut in.
  bool regular(SlabPoint v);

 private:
  enum class Part { kept, removed };
  void flood(SlabPoint v, TetList& seeds, Part part);

  const SlabTetrahedra& tets_;
  const Fates& fate_;
  IndexGroups<SlabPoint, TetIndex> star_;  // of each point: the tetrahedra that have it
  Table<SlabPoint, std::uint32_t> seen_vertex_;
  Table<TetIndex, std::uint32_t> seen_tet_;
  std::uint32_t vertex_epoch_ = 0, tet_epoch_ = 0;
};

}  // namespace odontoscope::delaunay
