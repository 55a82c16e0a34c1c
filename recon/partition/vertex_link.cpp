#include "recon/partition/vertex_link.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "recon/core/union_find.h"

namespace odontoscope::partition {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

}  // namespace

VertexLink::VertexLink(std::vector<LinkTriangle> triangles) : triangles_(std::move(triangles)) {
  struct Side {
    std::uint32_t a, b, triangle;
    int k;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles_[t].v[(k + 1) % 3], b = triangles_[t].v[(k + 2) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) { return std::tie(p.a, p.b, p.triangle) < std::tie(q.a, q.b, q.triangle); });
  across_.assign(triangles_.size(), {none, none, none});
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].a != sides[i + 1].a || sides[i].b != sides[i + 1].b) continue;
    across_[sides[i].triangle][sides[i].k] = sides[i + 1].triangle;
    across_[sides[i + 1].triangle][sides[i + 1].k] = sides[i].triangle;
  }
}

std::vector<VertexLink::Part> VertexLink::parts() const {
  std::vector<Label> labels;
  for (const LinkTriangle& triangle : triangles_)
    if (triangle.label != void_label) labels.push_back(triangle.label);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  std::vector<Part> found;
  for (const Label label : labels) {
    found.push_back({std::vector<bool>(triangles_.size()), false, label});
    for (std::size_t t = 0; t < triangles_.size(); ++t) found.back().in[t] = triangles_[t].label == label;
  }
  if (labels.size() > 1) {
    found.push_back({std::vector<bool>(triangles_.size()), true, void_label});
    for (std::size_t t = 0; t < triangles_.size(); ++t) found.back().in[t] = triangles_[t].label != void_label;
  }
  return found;
}

/// One piece, without a pinch, and of Euler characteristic 1; 2 is the whole sphere.
bool VertexLink::is_disc(const std::vector<bool>& in) const {
  std::vector<std::pair<std::uint32_t, int>> corners;   // link vertex; +1 for a triangle there, -1 for an edge within the part
  UnionFind joined(triangles_.size());
  std::size_t faces = 0, inner = 0, pieces = 0;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (!in[t]) continue;
    ++faces;
    ++pieces;
    for (int k = 0; k < 3; ++k) {
      corners.emplace_back(triangles_[t].v[k], 1);
      const std::uint32_t other = across_[t][k];
      if (other == none || !in[other] || other < t) continue;
      ++inner;
      corners.emplace_back(triangles_[t].v[(k + 1) % 3], -1);
      corners.emplace_back(triangles_[t].v[(k + 2) % 3], -1);
      if (joined.find(t) != joined.find(other)) {
        joined.join(t, other);
        --pieces;
      }
    }
  }
  if (pieces != 1) return false;
  std::sort(corners.begin(), corners.end());
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < corners.size();) {
    int fans = 0;
    const std::uint32_t at = corners[i].first;
    for (; i < corners.size() && corners[i].first == at; ++i) fans += corners[i].second;
    if (fans > 1) return false;
    ++vertices;
  }
  const auto euler = static_cast<long>(vertices) - static_cast<long>(3 * faces - inner) + static_cast<long>(faces);
  return euler == 1 || euler == 2;
}

bool VertexLink::regular() const {
  for (const Part& part : parts())
    if (!is_disc(part.in)) return false;
  return true;
}

/// Edge-connected; `touches_outside`: whether each has an edge beyond which there is nothing. With the outside, all that do are one piece.
std::vector<std::vector<std::uint32_t>> VertexLink::pieces(const std::vector<bool>& in, bool with_outside, std::vector<bool>& touches_outside) const {
  const auto outside = static_cast<std::uint32_t>(triangles_.size());
  UnionFind joined(triangles_.size() + 1);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (!in[t]) continue;
    for (int k = 0; k < 3; ++k) {
      if (across_[t][k] == none) {
        if (with_outside) joined.join(t, outside);
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
    touches_outside.push_back(with_outside && joined.find(outside) == root);
    list.push_back(std::move(group));
  }
  return list;
}

/// The label with the most edges beside the piece.
Label VertexLink::commonest_beside(const std::vector<std::uint32_t>& piece, bool material) const {
  std::vector<bool> in(triangles_.size(), false);
  for (const std::uint32_t t : piece) in[t] = true;
  std::map<Label, std::size_t> edges;
  for (const std::uint32_t t : piece)
    for (const std::uint32_t other : across_[t]) {
      const Label beside = other == none ? void_label : triangles_[other].label;
      if (other != none && in[other]) continue;
      if (!material || beside != void_label) ++edges[beside];
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
    if (is_disc(part.in)) continue;
    std::vector<bool> outside;
    const auto own = pieces(part.in, false, outside);
    if (own.size() > 1)
      for (const auto& piece : own) add(piece, part.materials ? void_label : commonest_beside(piece, false));
    std::vector<bool> rest(part.in.size());
    for (std::size_t t = 0; t < rest.size(); ++t) rest[t] = !part.in[t];
    const auto others = pieces(rest, true, outside);
    const bool something_outside = std::find(outside.begin(), outside.end(), true) != outside.end();
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (outside[i] || (others.size() == 1 && !something_outside)) continue;
      add(others[i], part.materials ? commonest_beside(others[i], true) : part.label);
    }
    break;
  }
  std::stable_sort(found.begin(), found.end(), [](const Mend& p, const Mend& q) {
    return p.cells.size() != q.cells.size() ? p.cells.size() < q.cells.size() : p.cells < q.cells;
  });
  return found;
}

}  // namespace odontoscope::partition
