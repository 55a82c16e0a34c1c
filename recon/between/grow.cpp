#include "recon/between/grow.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "recon/core/limits.h"

namespace odontoscope::between {
namespace {

constexpr int neighbours = 27;
constexpr int own_bit = 13;
constexpr std::array face_bits{4, 10, 12, 14, 16, 22};

}  // namespace

Grower::Grower(LayerStack& stack, const RegionGraph& graph, double step)
    : stack_(stack),
      graph_(graph),
      unjoined_(graph.links),
      seals_left_(graph.implied.voids - 1),
      pieces_(graph.hollow.size()),
      queued_(stack.material.size(), 0),
      room_(limits::join_room * step),
      seen_(stack.material.size(), 0),
      steps_left_(limits::join_search_steps * stack.material.size()) {}

void Grower::offer(std::size_t voxel) {
  if (stack_.material[voxel] || queued_[voxel] || !(stack_.field[voxel] < level_) || !stack_.free(voxel)) return;
  queued_[voxel] = 1;
  queue_.push({stack_.field[voxel], voxel});
}

void Grower::offer_all(double level) {
  level_ = level;
  for (std::size_t voxel = 0; voxel < stack_.material.size(); ++voxel) {
    if (stack_.material[voxel] || !stack_.free(voxel)) continue;
    const bool touches = std::any_of(face_bits.begin(), face_bits.end(),
                                     [&](int bit) { return stack_.material[stack_.neighbour(voxel, bit)] != 0; });
    if (touches) offer(voxel);
  }
}

void Grower::grow(double level) {
  offer_all(level);
  run(false);
}

void Grower::grow_until_joined() {
  if (joined()) return;
  offer_all(std::numeric_limits<double>::infinity());
  run(true);
  while (!queue_.empty()) {
    queued_[queue_.top().voxel] = 0;
    queue_.pop();
  }
}

void Grower::run(bool until_joined) {
  while (!queue_.empty()) {
    if (until_joined && joined()) return;
    const std::size_t voxel = queue_.top().voxel;
    queue_.pop();
    queued_[voxel] = 0;
    if (!may_take(voxel)) continue;
    take(voxel);
    for (int bit = 0; bit < neighbours; ++bit) {
      if (bit != own_bit) offer(stack_.neighbour(voxel, bit));
    }
  }
}

bool Grower::may_take(std::size_t voxel) {
  const Neighbourhood around = stack_.around(voxel);
  const LocalPieces pieces = local_pieces(around);
  if (pieces.material == 0 || pieces.voids == 0) return false;
  if (corner_contact(around | 1u << own_bit) || crowds(voxel)) return false;
  if (pieces.simple()) return true;
  if (pieces.material == 2 && pieces.voids == 1) return may_join(voxel, pieces);
  if (pieces.material == 1 && pieces.voids == 2) return may_seal(voxel, pieces);
  return false;
}

/// Is the voxel outside the given contours of the layer below or above it, with hardly room between?
bool Grower::tight(std::size_t voxel, std::ptrdiff_t up) const {
  const std::ptrdiff_t k = stack_.layer_of(voxel) + up;
  if (k != 0 && k != stack_.layers - 1) return false;
  const std::size_t given = stack_.neighbour(voxel, own_bit + 9 * static_cast<int>(up));
  return !stack_.material[given] && stack_.field[given] < room_;
}

/// Would material here pass a given contour that it must not overlap, with hardly room for its own contour? So it would
/// where there is given material beside it with void above. A traced contour could not keep clear of it.
bool Grower::crowds(std::size_t voxel) const {
  for (const int up : {-1, 1}) {
    if (!tight(voxel, up)) continue;
    for (int bit = 9; bit < 18; ++bit) {
      const std::size_t beside = stack_.neighbour(voxel, bit);
      if (bit != own_bit && !stack_.material[beside] && stack_.material[stack_.neighbour(beside, own_bit + 9 * up)])
        return true;
    }
  }
  return false;
}

/// Would material beside crowd a given contour without this voxel?
bool Grower::uncovers(std::size_t voxel) const {
  for (const int up : {-1, 1}) {
    const std::ptrdiff_t k = stack_.layer_of(voxel) + up;
    if ((k != 0 && k != stack_.layers - 1) || !stack_.material[stack_.neighbour(voxel, own_bit + 9 * up)]) continue;
    for (int bit = 9; bit < 18; ++bit) {
      const std::size_t beside = stack_.neighbour(voxel, bit);
      if (bit != own_bit && stack_.material[beside] && tight(beside, up)) return true;
    }
  }
  return false;
}

/// Two pieces of material meet here: for the first time of a linked pair of regions?
bool Grower::may_join(std::size_t voxel, const LocalPieces& pieces) {
  const auto regions_of = [&](Neighbourhood bits) {
    std::set<RegionId> regions;
    for (; bits != 0; bits &= bits - 1) regions.insert(stack_.region[stack_.neighbour(voxel, __builtin_ctz(bits))]);
    return regions;
  };
  for (const RegionId a : regions_of(pieces.material_bits[0])) {
    for (const RegionId b : regions_of(pieces.material_bits[1])) {
      const auto pair = unjoined_.find(std::minmax(a, b));
      if (pair == unjoined_.end()) continue;
      unjoined_.erase(pair);
      pieces_.join(a, b);
      return true;
    }
  }
  return false;
}

void Grower::reach(Search& search, std::size_t at) {
  seen_[at] = search.number;
  search.found.push_back(at);
  const std::ptrdiff_t k = stack_.layer_of(at);
  if (k == 0 || k == stack_.layers - 1) search.regions.insert(stack_.region[at]);
}

/// Takes one more voxel's neighbours into a search. false: it has met the other one, or searching took too long.
bool Grower::advance(Search& search, const Search& other, std::size_t sealed) {
  if (steps_left_ == 0) return false;
  --steps_left_;
  const std::size_t at = search.found[search.next++];
  const auto index = static_cast<std::ptrdiff_t>(at);
  const std::ptrdiff_t i = index % stack_.columns, j = index / stack_.columns % stack_.rows, k = stack_.layer_of(at);
  for (int bit = 0; bit < neighbours; ++bit) {
    const std::ptrdiff_t x = i + bit % 3 - 1, y = j + bit / 3 % 3 - 1, z = k + bit / 9 - 1;
    if (x < 0 || y < 0 || z < 0 || x >= stack_.columns || y >= stack_.rows || z >= stack_.layers) continue;
    const std::size_t there = stack_.at(x, y, z);
    if (there == sealed || stack_.material[there] || seen_[there] == search.number) continue;
    if (seen_[there] == other.number) return false;
    reach(search, there);
  }
  return true;
}

/// Two pieces of void would lose each other here: may they, all ways round considered? Both are searched in turns until
/// they meet, or one is known as a whole; then each void group must lie in one of them, and none may be without any.
bool Grower::may_seal(std::size_t voxel, const LocalPieces& pieces) {
  if (seals_left_ == 0) return false;
  std::array<Search, 2> searches;
  for (std::size_t n = 0; n < 2; ++n) {
    searches[n].number = ++searches_;
    for (Neighbourhood bits = pieces.void_bits[n]; bits != 0; bits &= bits - 1)
      reach(searches[n], stack_.neighbour(voxel, __builtin_ctz(bits)));
  }
  std::size_t turn = 0;
  while (searches[turn].next < searches[turn].found.size()) {
    if (!advance(searches[turn], searches[1 - turn], voxel)) return false;
    turn = 1 - turn;
  }
  Search &whole = searches[turn], &rest = searches[1 - turn];
  std::vector<std::size_t> found(graph_.hollow.size(), 0);
  for (const RegionId region : whole.regions) ++found[graph_.void_group[region]];
  for (const RegionId region : whole.regions) {
    const RegionId group = graph_.void_group[region];
    if (found[group] != graph_.void_group_size[group]) return false;
  }
  while (rest.regions.empty() && rest.next < rest.found.size()) {
    if (!advance(rest, whole, voxel)) return false;
  }
  if (whole.regions.empty() || rest.regions.empty()) return false;
  --seals_left_;
  return true;
}

void Grower::take(std::size_t voxel) {
  stack_.material[voxel] = 1;
  for (const int bit : face_bits) {
    const std::size_t there = stack_.neighbour(voxel, bit);
    if (!stack_.material[there]) continue;
    stack_.region[voxel] = stack_.region[there];
    return;
  }
}

void Grower::give_back() {
  std::priority_queue<Candidate> queue;  // with fields negated: the largest first
  const auto offer_back = [&](std::size_t voxel) {
    if (!stack_.material[voxel] || queued_[voxel] || stack_.field[voxel] < 0 || !stack_.free(voxel)) return;
    queued_[voxel] = 1;
    queue.push({-stack_.field[voxel], voxel});
  };
  for (std::size_t voxel = 0; voxel < stack_.material.size(); ++voxel) offer_back(voxel);
  while (!queue.empty()) {
    const std::size_t voxel = queue.top().voxel;
    queue.pop();
    queued_[voxel] = 0;
    const Neighbourhood around = stack_.around(voxel);
    if (!local_pieces(around).simple() || corner_contact(around & ~(1u << own_bit)) || uncovers(voxel)) continue;
    stack_.material[voxel] = 0;
    for (int bit = 0; bit < neighbours; ++bit) {
      if (bit != own_bit) offer_back(stack_.neighbour(voxel, bit));
    }
  }
}

void Grower::restore(const LayerStack& stack, const Grower& state) {
  stack_ = stack;
  unjoined_ = state.unjoined_;
  seals_left_ = state.seals_left_;
  pieces_ = state.pieces_;
  steps_left_ = state.steps_left_;
}

}  // namespace odontoscope::between
