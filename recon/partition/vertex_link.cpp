#include "recon/partition/vertex_link.h"

#include <algorithm>
#include <map>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/union_find.h"
#include "recon/delaunay/planar.h"

namespace odontoscope::partition {

using delaunay::none;

VertexLink::VertexLink(std::vector<LinkTriangle> triangles) : triangles_(std::move(triangles)) {
  number_corners();
  match_edges();
}

void VertexLink::number_corners() {
  std::vector<std::uint32_t> names;
  names.reserve(3 * triangles_.size());
  for (const LinkTriangle& triangle : triangles_) names.insert(names.end(), triangle.v.begin(), triangle.v.end());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  vertices_ = names.size();
  if (vertices_ > 0xffff) throw InternalError("a point of a partition has more neighbours than can be counted");
  corners_.resize(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k)
      corners_[t][k] =
          static_cast<std::uint16_t>(std::lower_bound(names.begin(), names.end(), triangles_[t].v[k]) - names.begin());
}

void VertexLink::match_edges() {
  across_.assign(triangles_.size(), {none, none, none});
  const auto match = [&](std::uint32_t one, std::uint32_t other) {  // 3 * triangle + side
    across_[one / 3][one % 3] = other / 3;
    across_[other / 3][other % 3] = one / 3;
  };
  constexpr std::size_t few = 64;  // a table of all pairs is small then
  std::vector<std::uint32_t> seen(vertices_ <= few ? vertices_ * vertices_ : 0, none);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;  // corners as one number, and 3 * triangle + side
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(corners_[t][(k + 1) % 3], corners_[t][(k + 2) % 3]);
      const std::size_t edge = a * vertices_ + b;
      if (seen.empty()) {
        sides.emplace_back(static_cast<std::uint32_t>(edge), 3 * t + k);
      } else if (seen[edge] == none) {
        seen[edge] = 3 * t + k;
      } else {
        match(seen[edge], 3 * t + k);
      }
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i].first == sides[i + 1].first) match(sides[i].second, sides[i + 1].second);
}

std::vector<VertexLink::Part> VertexLink::parts() const {
  std::vector<Part> found;
  for (const LinkTriangle& triangle : triangles_) {
    if (triangle.label == void_label) continue;
    if (std::none_of(found.begin(), found.end(), [&](const Part& part) { return part.label == triangle.label; }))
      found.push_back({false, triangle.label});
  }
  if (found.size() > 1) found.push_back({true, void_label});
  return found;
}

/// One piece, without a pinch, and of Euler characteristic 1; 2 is the whole sphere.
bool VertexLink::is_disc(const Part& part) const {
  std::vector<std::int16_t> fans(vertices_, 0);  // at each link vertex: triangles of the part less edges within it
  std::vector<std::uint8_t> used(vertices_, 0);
  std::vector<std::uint32_t> stack;
  std::size_t faces = 0, inner = 0;
  std::uint32_t first = none;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (!part.has(triangles_[t].label)) continue;
    ++faces;
    if (first == none) first = t;
    for (int k = 0; k < 3; ++k) {
      ++fans[corners_[t][k]];
      used[corners_[t][k]] = 1;
      const std::uint32_t other = across_[t][k];
      if (other == none || other < t || !part.has(triangles_[other].label)) continue;
      ++inner;
      --fans[corners_[t][(k + 1) % 3]];
      --fans[corners_[t][(k + 2) % 3]];
    }
  }
  std::size_t vertices = 0;
  for (std::size_t v = 0; v < vertices_; ++v) {
    if (fans[v] > 1) return false;
    vertices += used[v];
  }
  const auto euler = static_cast<long>(vertices) - static_cast<long>(3 * faces - inner) + static_cast<long>(faces);
  if (euler != 1 && euler != 2) return false;
  std::vector<std::uint8_t> seen(triangles_.size(), 0);
  std::size_t reached = 0;
  for (stack.push_back(first), seen[first] = 1; !stack.empty();) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    ++reached;
    for (const std::uint32_t other : across_[t]) {
      if (other == none || seen[other] || !part.has(triangles_[other].label)) continue;
      seen[other] = 1;
      stack.push_back(other);
    }
  }
  return reached == faces;
}

bool VertexLink::regular() const {
  for (const Part& part : parts())
    if (!is_disc(part)) return false;
  return true;
}

/// Edge-connected; `touches_outside`: whether each has an edge beyond which there is nothing. Where the outside joins,
/// all that do are one piece.
std::vector<std::vector<std::uint32_t>> VertexLink::pieces(const std::vector<bool>& in, Outside beyond,
                                                           std::vector<bool>& touches_outside) const {
  const auto outside = static_cast<std::uint32_t>(triangles_.size());
  UnionFind joined(triangles_.size() + 1);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (!in[t]) continue;
    for (int k = 0; k < 3; ++k) {
      if (across_[t][k] == none) {
        if (beyond == Outside::joins) joined.join(t, outside);
      } else if (in[across_[t][k]]) {
        joined.join(t, across_[t][k]);
      }
    }
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    if (in[t]) groups[joined.find(t)].push_back(t);
  std::vector<std::vector<std::uint32_t>> list;
  touches_outside.clear();
  for (auto& [root, group] : groups) {
    touches_outside.push_back(beyond == Outside::joins && joined.find(outside) == root);
    list.push_back(std::move(group));
  }
  return list;
}

/// The label with the most edges beside the piece.
Label VertexLink::commonest_beside(const std::vector<std::uint32_t>& piece, Among among) const {
  std::vector<bool> in(triangles_.size(), false);
  for (const std::uint32_t t : piece) in[t] = true;
  std::map<Label, std::size_t> edges;
  for (const std::uint32_t t : piece)
    for (const std::uint32_t other : across_[t]) {
      const Label beside = other == none ? void_label : triangles_[other].label;
      if (other != none && in[other]) continue;
      if (among == Among::all || beside != void_label) ++edges[beside];
    }
  Label best = void_label;
  std::size_t most = 0;
  for (const auto& [label, count] : edges)
    if (count > most) {
      most = count;
      best = label;
    }
  return best;
}

std::vector<Mend> VertexLink::all_mends() const {
  std::vector<Mend> found;
  const auto add = [&](const std::vector<std::uint32_t>& piece, Label label) {
    Mend mend{{}, label};
    for (const std::uint32_t t : piece)
      if (triangles_[t].label != label) mend.cells.push_back(triangles_[t].cell);
    std::sort(mend.cells.begin(), mend.cells.end());
    if (!mend.cells.empty()) found.push_back(std::move(mend));
  };
  for (const Part& part : parts()) {
    if (is_disc(part)) continue;
    std::vector<bool> in(triangles_.size()), rest(triangles_.size());
    for (std::size_t t = 0; t < in.size(); ++t) {
      in[t] = part.has(triangles_[t].label);
      rest[t] = !in[t];
    }
    std::vector<bool> outside;
    const auto own = pieces(in, Outside::apart, outside);
    if (own.size() > 1)
      for (const auto& piece : own) add(piece, part.materials ? void_label : commonest_beside(piece, Among::all));
    const auto others = pieces(rest, Outside::joins, outside);
    const bool something_outside = std::find(outside.begin(), outside.end(), true) != outside.end();
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (outside[i] || (others.size() == 1 && !something_outside)) continue;
      add(others[i], part.materials ? commonest_beside(others[i], Among::materials) : part.label);
    }
    break;
  }
  std::stable_sort(found.begin(), found.end(), [](const Mend& p, const Mend& q) {
    return p.cells.size() != q.cells.size() ? p.cells.size() < q.cells.size() : p.cells < q.cells;
  });
  return found;
}

}  // namespace odontoscope::partition
