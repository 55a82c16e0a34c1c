#include "recon/cavity/bundling.h"

#include <algorithm>

#include "recon/cavity/limits.h"

namespace odontoscope::cavity {
namespace {

using Path = std::vector<NodeIndex>;

class Bundler {
 public:
  Bundler(const MedialGraph& graph, const std::vector<char>& chamber) : graph_(graph), chamber_(chamber) {}

  /// The path with the nodes of known ones, which it then belongs to.
  Path add(Path path) {
    Meeting longest;
    const Path* with = nullptr;
    for (const Path& known : known_) {
      const Meeting met = side_by_side(path, known);
      if (with != nullptr && met.own <= longest.own) continue;
      longest = met;
      with = &known;
    }
    if (with != nullptr && longest.own > 0 && !chamber_[path[longest.own]]) {
      Path made(with->begin(), with->begin() + static_cast<std::ptrdiff_t>(longest.other) + 1);
      const std::size_t rest = longest.own + (made.back() == path[longest.own] ? 1 : 0);
      made.insert(made.end(), path.begin() + static_cast<std::ptrdiff_t>(rest), path.end());
      path = std::move(made);
    }
    known_.push_back(path);
    return path;
  }

 private:
  /// The last places where two paths are side by side; of `own` never its end.
  struct Meeting {
    std::size_t own = 0, other = 0;
  };

  double apart(NodeIndex a, NodeIndex b) const { return length(graph_.nodes[a].at - graph_.nodes[b].at); }

  Meeting side_by_side(const Path& path, const Path& known) const {
    Meeting met;
    for (std::size_t own = 0, other = 0; own + 1 < path.size(); ++own) {
      // On along the known one, no farther ahead than a ball reaches, to what is nearest.
      std::size_t best = other;
      double ahead = 0;
      for (std::size_t k = other; k < known.size() && ahead <= 2 * graph_.nodes[path[own]].radius; ++k) {
        if (apart(path[own], known[k]) < apart(path[own], known[best])) best = k;
        if (k + 1 < known.size()) ahead += apart(known[k], known[k + 1]);
      }
      if (apart(path[own], known[best]) > limits::together * std::min(graph_.nodes[path[own]].radius, graph_.nodes[known[best]].radius)) break;
      other = best;
      met = {own, other};
    }
    return met;
  }

  const MedialGraph& graph_;
  const std::vector<char>& chamber_;
  std::vector<Path> known_;
};

/// Two paths from the root as a handle; false where one leads along all of the other.
bool part(const Path& one, const Path& other, Handle& handle) {
  std::size_t same = 0;
  while (same < one.size() && same < other.size() && one[same] == other[same]) ++same;
  if (same == 0 || same == one.size() || same == other.size()) return false;
  handle.fork = one[same - 1];
  handle.one.assign(one.begin() + static_cast<std::ptrdiff_t>(same), one.end());
  handle.other.assign(other.begin() + static_cast<std::ptrdiff_t>(same), other.end());
  return true;
}

}  // namespace

void bundle(const MedialGraph& graph, const PathTree& tree, const std::vector<char>& chamber, std::vector<MedialCanal>& canals, std::vector<Handle>& handles) {
  Bundler bundler(graph, chamber);
  for (MedialCanal& canal : canals) canal.path = bundler.add(canal.path);
  for (Handle& handle : handles) {
    const Path one = bundler.add(path_to(tree, handle.one.back())), other = bundler.add(path_to(tree, handle.other.back()));
    part(one, other, handle);
  }
}

}  // namespace odontoscope::cavity
