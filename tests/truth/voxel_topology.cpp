#include "voxel_topology.h"

#include <array>
#include <bit>

#include "recon/core/union_find.h"

namespace odontoscope::test {
namespace {

/// Eight times what one grid point adds to the Euler characteristic, by which of its voxels are material.
std::array<int, 256> octant_shares() {
  std::array<int, 256> shares{};
  for (unsigned set = 0; set < 256; ++set) {
    const auto any = [set](unsigned fixed, unsigned at) {  // of those voxels whose bits in `fixed` are those of `at`
      for (unsigned v = 0; v < 8; ++v)
        if ((v & fixed) == at && (set >> v & 1)) return 1;
      return 0;
    };
    int edges = 0, faces = 0;
    for (unsigned axis = 1; axis < 8; axis <<= 1) {
      for (const unsigned end : {0u, axis}) edges += any(axis, end);  // half an edge leaves the point along the axis
      const unsigned others = 7u - axis;                              // a quarter of a face lies across it
      for (unsigned at = 0; at < 8; ++at)
        if ((at & axis) == 0) faces += any(others, at);
    }
    shares[set] = 8 * any(0, 0) - 4 * edges + 2 * faces - std::popcount(set);
  }
  return shares;
}

struct Run {
  std::size_t begin, end;  // columns
};

/// Runs of equal voxels along the rows of a picture that has a margin of void all round.
class Runs {
 public:
  Runs(const Voxels& voxels, std::uint8_t bit, bool material)
      : rows_(voxels.rows + 2), first_((voxels.layers + 2) * rows_ + 1, 0) {
    std::size_t line = 0;
    for (std::size_t k = 0; k < voxels.layers + 2; ++k) {
      for (std::size_t j = 0; j < rows_; ++j) {
        const bool margin = k == 0 || k > voxels.layers || j == 0 || j > voxels.rows;
        add_line(voxels, bit, material, margin ? nullptr : &voxels.values[voxels.index(0, j - 1, k - 1)]);
        first_[++line] = runs_.size();
      }
    }
  }

  /// Groups of runs that overlap, or with `reach` 1 touch so much as in a corner.
  long groups(bool corners) const {
    UnionFind sets(runs_.size());
    const std::size_t lines = first_.size() - 1;
    for (std::size_t line = 0; line < lines; ++line) {
      const std::size_t j = line % rows_;
      if (j > 0) join(sets, line, line - 1, corners);
      if (line >= rows_) join(sets, line, line - rows_, corners);
      if (corners && line >= rows_ && j > 0) join(sets, line, line - rows_ - 1, corners);
      if (corners && line >= rows_ && j + 1 < rows_) join(sets, line, line - rows_ + 1, corners);
    }
    long count = 0;
    for (std::uint32_t i = 0; i < runs_.size(); ++i) count += sets.find(i) == i;
    return count;
  }

 private:
  void add_line(const Voxels& voxels, std::uint8_t bit, bool material, const std::uint8_t* row) {
    const auto is = [&](std::size_t column) {  // in the picture with margin
      const bool set = row && column > 0 && column <= voxels.columns && (row[column - 1] & bit);
      return set == material;
    };
    for (std::size_t i = 0; i < voxels.columns + 2;) {
      if (!is(i)) {
        ++i;
        continue;
      }
      const std::size_t begin = i;
      while (i < voxels.columns + 2 && is(i)) ++i;
      runs_.push_back({begin, i});
    }
  }

  void join(UnionFind& sets, std::size_t a, std::size_t b, bool corners) const {
    const std::size_t reach = corners ? 1 : 0;
    std::size_t i = first_[a], j = first_[b];
    while (i < first_[a + 1] && j < first_[b + 1]) {
      if (runs_[i].begin < runs_[j].end + reach && runs_[j].begin < runs_[i].end + reach)
        sets.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      (runs_[i].end < runs_[j].end ? i : j) += 1;
    }
  }

  std::size_t rows_;
  std::vector<std::size_t> first_;  // run of each line, and one more
  std::vector<Run> runs_;
};

long euler_characteristic(const Voxels& v, std::uint8_t bit) {
  static const std::array<int, 256> shares = octant_shares();
  long sum = 0;
  const auto row = [&](std::size_t j, std::size_t k) -> const std::uint8_t* {  // counted from 1, margins void
    return j == 0 || j > v.rows || k == 0 || k > v.layers ? nullptr : &v.values[v.index(0, j - 1, k - 1)];
  };
  for (std::size_t k = 0; k <= v.layers; ++k) {
    for (std::size_t j = 0; j <= v.rows; ++j) {
      const std::array<const std::uint8_t*, 4> rows{row(j, k), row(j + 1, k), row(j, k + 1), row(j + 1, k + 1)};
      unsigned left = 0;  // bits 0, 2, 4, 6: the voxels before the grid point
      for (std::size_t i = 0; i <= v.columns; ++i) {
        unsigned right = 0;
        if (i < v.columns)
          for (unsigned r = 0; r < 4; ++r)
            if (rows[r] && (rows[r][i] & bit)) right |= 1u << 2 * r;
        sum += shares[left | right << 1];
        left = right;
      }
    }
  }
  return sum / 8;
}

}  // namespace

std::string in_short(const Topology& t) {
  return std::to_string(t.pieces) + "/" + std::to_string(t.handles) + "/" + std::to_string(t.bubbles);
}

Topology topology_of(const Voxels& voxels, std::uint8_t bit) {
  Topology found;
  found.pieces = Runs(voxels, bit, true).groups(true);
  found.bubbles = Runs(voxels, bit, false).groups(false) - 1;
  found.handles = found.pieces + found.bubbles - euler_characteristic(voxels, bit);
  return found;
}

}  // namespace odontoscope::test
