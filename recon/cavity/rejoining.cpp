#include "recon/cavity/rejoining.h"

#include <algorithm>
#include <map>
#include <utility>

#include "recon/cavity/limits.h"

namespace odontoscope::cavity {
namespace {

using Path = std::vector<NodeIndex>;

class Rejoiner {
 public:
  Rejoiner(const MedialGraph& graph, const PathTree& tree, std::vector<MedialCanal> canals,
           const std::vector<char>& chamber)
      : graph_(graph), tree_(tree), chamber_(chamber), made_{std::move(canals), {}} {
    for (const MedialCanal& canal : made_.canals) count(canal.path, 1);
  }

  /// False: no canal goes down either side.
  bool add(const Handle& handle) {
    const Side one = side_of(handle.fork, handle.one), other = side_of(handle.fork, handle.other);
    if (one.users.empty() && other.users.empty()) return false;
    if (!one.users.empty() && !other.users.empty()) {
      join(handle, one, other);
    } else if (!one.users.empty()) {
      go_round(handle.one, handle.other, one);
    } else {
      go_round(handle.other, handle.one, other);
    }
    return true;
  }

  /// Both sides are ways, and no canal comes near.
  bool hangs_free(const Handle& handle) const {
    if (slender(handle.one, 0, handle.one.size()) == 0 || slender(handle.other, 0, handle.other.size()) == 0)
      return false;
    Path loop = handle.loop();
    std::sort(loop.begin(), loop.end());
    return std::none_of(made_.canals.begin(), made_.canals.end(), [&](const MedialCanal& canal) {
      return std::any_of(canal.path.begin(), canal.path.end(),
                         [&](NodeIndex n) { return !chamber_[n] && std::binary_search(loop.begin(), loop.end(), n); });
    });
  }

  /// A canal that ends where the handle's sides meet.
  void end_at(const Handle& handle) {
    MedialCanal canal{path_to(tree_, handle.one.back()), 0};
    canal.beyond = tree_.distance[canal.path.back()] + graph_.nodes[canal.path.back()].radius;
    count(canal.path, 1);
    made_.canals.push_back(std::move(canal));
  }

  Rejoined take() { return std::move(made_); }

 private:
  /// Canals that go from the fork down this side, and how far: the last of its nodes that any of them passes.
  struct Side {
    struct User {
      std::size_t canal, fork, leaves;  // places in its path
    };
    std::vector<User> users;  // those that go as far as the last does
    std::size_t last = 0;     // of the side's nodes
  };

  Side side_of(NodeIndex fork, const Path& side) const {
    Side found;
    for (std::size_t c = 0; c < made_.canals.size(); ++c) {
      const Path& path = made_.canals[c].path;
      const auto at = std::find(path.begin(), path.end(), fork);
      std::size_t gone = 0;
      const auto on = static_cast<std::size_t>(at - path.begin());
      while (at != path.end() && on + 1 + gone < path.size() && gone < side.size() && path[on + 1 + gone] == side[gone])
        ++gone;
      if (gone == 0 || slender(side, 0, gone) == 0) continue;
      if (found.users.empty() || gone - 1 > found.last) found = {{}, gone - 1};
      if (gone - 1 == found.last) found.users.push_back({c, on, on + gone});
    }
    return found;
  }

  /// Its length, without what lies in the chamber, if it is long for its width; else 0.
  double slender(const Path& path, std::size_t first, std::size_t end) const {
    double way = 0, weight = 0;
    for (std::size_t i = first + 1; i < end; ++i) {
      if (chamber_[path[i]]) continue;
      const double step = length(graph_.nodes[path[i]].at - graph_.nodes[path[i - 1]].at);
      way += step;
      weight += step * graph_.nodes[path[i]].radius;
    }
    return way * way >= limits::branch_slenderness * weight ? way : 0;
  }

  /// Canals use `side` and leave it at its node `used.last`: one of them goes the other way.
  void go_round(const Path& side, const Path& round, const Side& used) {
    Path detour = round;  // from the fork to where the canals leave the side
    detour.insert(detour.end(), side.rbegin(), side.rend() - static_cast<std::ptrdiff_t>(used.last));
    if (chamber_[detour.back()] || slender(detour, 0, detour.size()) == 0) return;
    const Point3 middle = graph_.nodes[detour[detour.size() / 2]].at;
    std::vector<Side::User> nearest = used.users;
    std::stable_sort(nearest.begin(), nearest.end(),
                     [&](const Side::User& a, const Side::User& b) { return far(a, middle) < far(b, middle); });
    for (const Side::User& user : nearest) {
      if (!spared(user)) continue;
      count(made_.canals[user.canal].path, -1);
      made_.canals[user.canal].path = led(user, detour);
      count(made_.canals[user.canal].path, 1);
      return;
    }
    MedialCanal more = made_.canals[nearest.front().canal];
    more.path = led(nearest.front(), detour);
    count(more.path, 1);
    made_.canals.push_back(std::move(more));
  }

  double far(const Side::User& user, const Point3& from) const {
    return length(graph_.nodes[made_.canals[user.canal].path.back()].at - from);
  }

  Path led(const Side::User& user, const Path& detour) const {
    const Path& path = made_.canals[user.canal].path;
    Path made(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(user.fork) + 1);
    made.insert(made.end(), detour.begin(), detour.end());
    const std::size_t join = made.size() - 1;
    made.insert(made.end(), path.begin() + static_cast<std::ptrdiff_t>(user.leaves) + 1, path.end());
    return straightened(made, join, user.fork + detour.size() / 2);
  }

  /// The tree's paths turn sharply where they meet, from one side up into the other: the shortest way from a little
  /// before there, but not before `first`, to a little after.
  Path straightened(const Path& path, std::size_t join, std::size_t first) const {
    const double reach = limits::join_reach * graph_.nodes[path[join]].radius;
    const auto step = [&](std::size_t i) { return length(graph_.nodes[path[i]].at - graph_.nodes[path[i + 1]].at); };
    std::size_t before = join, after = join;
    for (double gone = 0; before > first && gone < reach; --before) gone += step(before - 1);
    for (double gone = 0; after + 1 < path.size() && gone < reach; ++after) gone += step(after);
    const Path direct = path_to(shortest_paths(graph_, path[before], path[after]), path[after]);
    Path made(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(before));
    made.insert(made.end(), direct.begin(), direct.end());
    made.insert(made.end(), path.begin() + static_cast<std::ptrdiff_t>(after) + 1, path.end());
    return made;
  }

  /// Whether other canals lead all along where this one would no longer.
  bool spared(const Side::User& user) const {
    const Path& path = made_.canals[user.canal].path;
    for (std::size_t i = user.fork; i < user.leaves; ++i)
      if (uses_.at(std::minmax(path[i], path[i + 1])) < 2) return false;
    return true;
  }

  void count(const Path& path, int by) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) uses_[std::minmax(path[i], path[i + 1])] += by;
  }

  /// Canals go on from both sides: what lies between is an isthmus, if it is long enough to be anything.
  void join(const Handle& handle, const Side& one, const Side& other) {
    Path between(handle.one.begin() + static_cast<std::ptrdiff_t>(one.last), handle.one.end());
    between.insert(between.end(), handle.other.rbegin(), handle.other.rend() - static_cast<std::ptrdiff_t>(other.last));
    if (slender(between, 0, between.size()) == 0) return;
    const Side::User& user = one.users.front();
    const Path& path = made_.canals[user.canal].path;
    Path way(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(user.leaves));
    way.insert(way.end(), between.begin(), between.end());
    made_.isthmuses.push_back(std::move(way));
  }

  const MedialGraph& graph_;
  const PathTree& tree_;
  const std::vector<char>& chamber_;
  Rejoined made_;
  std::map<std::pair<NodeIndex, NodeIndex>, int> uses_;  // of each way, by how many canals
};

}  // namespace

Rejoined rejoined(const MedialGraph& graph, const PathTree& tree, std::vector<MedialCanal> canals,
                  const std::vector<Handle>& handles, const std::vector<char>& chamber) {
  Rejoiner rejoiner(graph, tree, std::move(canals), chamber);
  std::vector<const Handle*> left;
  for (const Handle& handle : handles) left.push_back(&handle);
  while (!left.empty()) {
    // A handle may hang on another one's second side.
    if (std::erase_if(left, [&](const Handle* handle) { return rejoiner.add(*handle); }) > 0) continue;
    if (rejoiner.hangs_free(*left.front()))
      rejoiner.end_at(*left.front());
    else
      left.erase(left.begin());
  }
  return rejoiner.take();
}

}  // namespace odontoscope::cavity
