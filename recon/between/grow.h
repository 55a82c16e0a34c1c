#pragma once
// Material grown from the given slices through the layers between them, with the topology under control. Inner part of
// joined.h, which tells the rules.

#include <queue>

#include "recon/between/layer_stack.h"
#include "recon/core/union_find.h"

namespace odontoscope::between {

class Grower {
 public:
  /// The stack must outlive the grower; `step` is that of the grid.
  Grower(LayerStack& stack, const RegionGraph& graph, double step);

  /// Grows over all voxels whose field is below the level, the least first.
  void grow(double level);
  /// Grows on, the least field first, until no join or seal is missing or nothing may grow.
  void grow_until_joined();
  /// All linked regions are joined, all unlinked voids parted.
  bool joined() const { return unjoined_.empty() && seals_left_ == 0; }
  /// Gives back what has no negative field and is not needed for the topology, the largest field first.
  void give_back();

  /// Copies of another grower's state, on stacks of the same size.
  void restore(const LayerStack& stack, const Grower& state);

 private:
  struct Candidate {
    double field;
    std::size_t voxel;
    bool operator<(const Candidate& other) const {  // the least comes out of the queue first
      return field != other.field ? field > other.field : voxel > other.voxel;
    }
  };

  /// Void that is connected, as far as it is known.
  struct Search {
    std::vector<std::size_t> found;
    std::size_t next = 0;
    std::set<RegionId> regions;
    std::uint32_t number = 0;
  };

  void offer(std::size_t voxel);
  void offer_all(double level);
  void run(bool until_joined);
  bool may_take(std::size_t voxel);
  bool tight(std::size_t voxel, std::ptrdiff_t up) const;
  bool crowds(std::size_t voxel) const;
  bool uncovers(std::size_t voxel) const;
  bool may_join(std::size_t voxel, const LocalPieces& pieces);
  bool may_seal(std::size_t voxel, const LocalPieces& pieces);
  void reach(Search& search, std::size_t at);
  bool advance(Search& search, const Search& other, std::size_t sealed);
  void take(std::size_t voxel);

  LayerStack& stack_;
  const RegionGraph& graph_;
  std::set<std::pair<RegionId, RegionId>> unjoined_;
  std::size_t seals_left_ = 0;
  UnionFind pieces_;  // of material, by region
  std::priority_queue<Candidate> queue_;
  std::vector<std::uint8_t> queued_;
  double level_ = 0;
  double room_;                      // distance from a given contour below which it is tight, mm
  std::vector<std::uint32_t> seen_;  // by searches, with their number
  std::uint32_t searches_ = 0;
  std::size_t steps_left_;  // of all searches
};

}  // namespace odontoscope::between
