#include "tests/support/cube_solids.h"

#include <algorithm>
#include <array>
#include <map>

namespace odontoscope::test {
namespace {

using Corner = std::array<std::size_t, 3>;

bool filled(const Picture& picture, long x, long y) {
  return y >= 0 && y < long(picture.size()) && x >= 0 && x < long(picture[std::size_t(y)].size()) &&
         picture[std::size_t(y)][std::size_t(x)] == '#';
}

/// The six tetrahedra round the cube's long diagonal, one for each order of the axes; neighbours agree on their common
/// face.
std::array<std::array<Corner, 4>, 6> tetrahedra_of(Corner low) {
  std::array<std::array<Corner, 4>, 6> result;
  std::array<std::size_t, 3> axes{0, 1, 2};
  for (auto& corners : result) {
    Corner at = low;
    corners[0] = at;
    for (std::size_t i = 0; i < 3; ++i) {
      ++at[axes[i]];
      corners[i + 1] = at;
    }
    const bool odd = (axes[1] + 3 - axes[0]) % 3 != 1;
    if (odd) std::swap(corners[2], corners[3]);
    std::next_permutation(axes.begin(), axes.end());
  }
  return result;
}

}  // namespace

Solid cubes(const std::vector<Picture>& layers) {
  Solid solid{"tooth", {}, {}, {}};
  std::map<Corner, PointIndex> number;
  const auto point = [&](Corner at) {
    const auto [known, added] = number.emplace(at, PointIndex(number.size()));
    if (added) solid.tetrahedra.points.push_back({double(at[0]), double(at[1]), double(at[2])});
    return known->second;
  };
  for (std::size_t z = 0; z < layers.size(); ++z)
    for (std::size_t y = 0; y < layers[z].size(); ++y)
      for (std::size_t x = 0; x < layers[z][y].size(); ++x) {
        if (layers[z][y][x] != '#') continue;
        for (const auto& t : tetrahedra_of({x, y, z}))
          solid.tetrahedra.tetrahedra.push_back({point(t[0]), point(t[1]), point(t[2]), point(t[3])});
      }
  solid.tetrahedra.labels.assign(solid.tetrahedra.tetrahedra.size(), 1);
  return solid;
}

Outlines::Outlines(const Picture& picture) {
  struct Step {
    long x, y;
    auto operator<=>(const Step&) const = default;
  };
  std::map<Step, Step> next;  // along the outlines, material on the left
  for (long y = 0; y < long(picture.size()); ++y)
    for (long x = 0; x < long(picture[std::size_t(y)].size()); ++x) {
      if (!filled(picture, x, y)) continue;
      if (!filled(picture, x, y - 1)) next[{x, y}] = {x + 1, y};
      if (!filled(picture, x + 1, y)) next[{x + 1, y}] = {x + 1, y + 1};
      if (!filled(picture, x, y + 1)) next[{x + 1, y + 1}] = {x, y + 1};
      if (!filled(picture, x - 1, y)) next[{x, y + 1}] = {x, y};
    }
  std::map<std::pair<Step, Step>, std::size_t> ring_of;
  while (!next.empty()) {
    const Step start = next.begin()->first;
    std::vector<Point2> ring;
    for (Step at = start;;) {
      const Step to = next.at(at);
      next.erase(at);
      ring_of[{at, to}] = rings_.size();
      ring.push_back({double(at.x), double(at.y)});
      if (to == start) break;
      at = to;
    }
    rings_.push_back(ring);
  }
  std::size_t count = 0;
  const auto pieces = pieces_of(picture, count);
  std::map<std::size_t, std::optional<std::size_t>> of_piece;
  // Rows from below: a piece's first cell has another piece, or nothing, beneath it.
  for (long y = 0; y < long(picture.size()); ++y)
    for (long x = 0; x < long(picture[std::size_t(y)].size()); ++x) {
      const bool material = filled(picture, x, y);
      const auto edge = material ? ring_of.find({{x, y}, {x + 1, y}}) : ring_of.find({{x + 1, y}, {x, y}});
      const std::size_t piece = pieces[std::size_t(y)][std::size_t(x)];
      const bool open = !material && piece == 0;
      of_piece.emplace(piece, open || edge == ring_of.end() ? std::nullopt : std::optional(edge->second));
    }
  for (const auto& row : pieces) {
    round_.emplace_back();
    for (std::size_t piece : row) round_.back().push_back(of_piece[piece]);
  }
}

ContourStack stack_of_cubes(const std::vector<Picture>& layers, const std::vector<std::size_t>& heights) {
  ContourStack stack;
  for (std::size_t z : heights) {
    Slice slice{double(z), {}};
    const Outlines outlines(layers[std::min(z, layers.size() - 1)]);
    for (const auto& ring : outlines.rings()) slice.contours.push_back({"tooth", ring});
    stack.slices.push_back(slice);
  }
  return stack;
}

std::vector<std::vector<std::size_t>> pieces_of(const Picture& picture, std::size_t& count) {
  constexpr std::size_t unknown = std::size_t(-1);
  std::vector<std::vector<std::size_t>> number(picture.size(), std::vector<std::size_t>(picture[0].size(), unknown));
  const auto flood = [&](std::size_t x0, std::size_t y0, std::size_t with) {
    std::vector<std::array<std::size_t, 2>> open{{x0, y0}};
    const char kind = picture[y0][x0];
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      if (y >= picture.size() || x >= picture[y].size() || number[y][x] != unknown || picture[y][x] != kind) continue;
      number[y][x] = with;
      for (const auto& [dx, dy] : {std::array<int, 2>{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        open.push_back({x + std::size_t(dx), y + std::size_t(dy)});  // below 0 wraps to far beyond the picture
    }
  };
  // Piece 0 is the void along the picture's rim, all of it, whether or not material parts it.
  for (std::size_t y = 0; y < picture.size(); ++y)
    for (std::size_t x = 0; x < picture[y].size(); ++x)
      if ((x == 0 || y == 0 || x + 1 == picture[y].size() || y + 1 == picture.size()) && picture[y][x] != '#')
        flood(x, y, 0);
  count = 1;
  for (std::size_t y = 0; y < picture.size(); ++y)
    for (std::size_t x = 0; x < picture[y].size(); ++x)
      if (number[y][x] == unknown) flood(x, y, count++);
  return number;
}

bool has_plain_corners(const Picture& picture) {
  for (long y = -1; y < long(picture.size()); ++y)
    for (long x = -1; x < long(picture[0].size()); ++x) {
      const bool a = filled(picture, x, y), b = filled(picture, x + 1, y), c = filled(picture, x, y + 1),
                 d = filled(picture, x + 1, y + 1);
      if (a == d && b == c && a != b) return false;
    }
  return true;
}

}  // namespace odontoscope::test
