// Borders shared exactly, or nearly; lattices; corners where many faces meet.

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/partition/partition_stacks.h"
#include "tests/support/strange_parts.h"

namespace odontoscope::test {
namespace {

/// The rings round all cells of one label, in a grid of corners; cells of one label that touch in a corner make a stack
/// that is not valid.
void add_cells(Slice& slice, const std::vector<Point2>& corner, const std::vector<int>& label, int side) {
  const auto at = [&](int i, int j) { return j * (side + 1) + i; };
  for (int wanted = 1; wanted <= 5; ++wanted) {
    std::map<int, int> next;
    std::map<std::pair<int, int>, bool> edges;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        if (label[std::size_t(j * side + i)] == wanted) {
          const int ring[] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          for (int e = 0; e < 4; ++e) {
            if (edges.erase({ring[(e + 1) % 4], ring[e]}) == 0) edges[{ring[e], ring[(e + 1) % 4]}] = true;
          }
        }
    for (const auto& [edge, there] : edges) next[edge.first] = edge.second;
    while (!next.empty()) {
      Ring ring;
      int v = next.begin()->first;
      while (next.contains(v)) {
        ring.push_back(corner[std::size_t(v)]);
        const int to = next[v];
        next.erase(v);
        v = to;
      }
      add_ring(slice, wanted, ring);
    }
  }
}

/// A grid with moved corners, cells of several structures and void: all borders shared.
ContourStack cells(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), side = std::clamp(int(std::sqrt(points / count / 2.0)), 2, 16),
            labels = random.whole(2, 5);
  const double jitter = random.chance(0.3) ? 0 : random.between(0, 0.45), hold = random.between(0, 1);
  const double step = one_of(random, {1.0, 0.1, 0.3});
  std::vector<Slice> slices(std::size_t(count), Slice{});
  std::vector<int> label(std::size_t(side * side), 0);
  for (Slice& slice : slices) {
    std::vector<Point2> corner;
    for (int j = 0; j <= side; ++j)
      for (int i = 0; i <= side; ++i)
        corner.push_back({step * (i + jitter * random.between(-1, 1)), step * (j + jitter * random.between(-1, 1))});
    for (int& l : label)
      if (!random.chance(hold)) l = random.whole(random.chance(0.3) ? 0 : 1, labels);
    add_cells(slice, corner, label, side);
  }
  return stack_slices(random, slices);
}

/// Rectangles of any structure on a lattice, whole borders or corners only.
ContourStack lattice(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), labels = random.whole(2, 5), rings = std::max(2, points / count / 6),
            side = random.whole(3, 6);
  const double step = one_of(random, {1.0, 0.1, 0.25, 0.3}), from = one_of(random, {0.0, -13.3, 0.7});
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices)
    for (int r = 0; r < rings; ++r) {
      const int i0 = random.below(side), j0 = random.below(side), i1 = random.whole(i0 + 1, side),
                j1 = random.whole(j0 + 1, side);
      const bool every = random.chance(0.4);
      Ring ring;
      const auto add = [&](int i, int j, bool corner) {
        if (every || corner) ring.push_back({from + i * step, from + j * step});
      };
      for (int i = i0; i < i1; ++i) add(i, j0, i == i0);
      for (int j = j0; j < j1; ++j) add(i1, j, j == j0);
      for (int i = i1; i > i0; --i) add(i, j1, i == i1);
      for (int j = j1; j > j0; --j) add(i0, j, j == j1);
      add_ring(slice, random.whole(1, labels), ring);
    }
  return stack_slices(random, slices);
}

/// Sectors about one point that drifts: three meet in a line; with more, or with the point shared by corners, four and
/// more meet.
ContourStack sectors(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), labels = random.chance(0.5) ? 3 : random.whole(2, 5);
  const int each = std::max(1, points / count / labels / 2);
  const double drift = random.between(0, 1.5), turn_by = random.between(0, 1);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (int k = 0; k < count; ++k) {
    const Point2 middle{random.between(-drift, drift), random.between(-drift, drift)};
    const Ring rim = regular({0, 0}, labels * each < 3 ? 4 : labels * each, turn_by * k, 3);
    const int n = int(rim.size()), part = n / labels;
    for (int label = 1; label <= labels; ++label) {
      Ring ring{middle};
      for (int i = (label - 1) * part; i <= (label == labels ? n : label * part); ++i)
        ring.push_back(rim[std::size_t(i % n)]);
      if (random.chance(0.9)) add_ring(slices[std::size_t(k)], label, ring);
    }
  }
  return stack_slices(random, slices);
}

/// Squares of different structures that meet in corners, on ground of another or of void.
ContourStack checkerboard(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), side = std::clamp(int(std::sqrt(points / count / 4.0)), 2, 10),
            labels = random.whole(2, 5);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices) {
    if (random.chance(0.5)) add_ring(slice, 1, box_of({-0.5, -0.5}, {side + 0.5, side + 0.5}));
    const double skew = random.chance(0.5) ? 0 : random.between(-0.7, 0.7);
    const int odd = random.below(2);
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        if ((i + j) % 2 == odd || random.chance(0.1)) {
          Ring square = box_of({double(i), double(j)}, {i + 1.0, j + 1.0});
          for (Point2& p : square) p.x += skew * p.y;
          add_ring(slice, random.whole(2, labels), square);
        }
  }
  return stack_slices(random, slices);
}

/// One left, others right of a straight border, with T-junctions inside its edge; now and then another comes between
/// them, or a slit opens.
ContourStack junctions(RandomNumbers& random, int points) {
  const int count = random.whole(2, 4), right = std::clamp(points / count / 4 - 1, 1, 12);
  std::vector<Slice> slices(std::size_t(count), Slice{});
  const double angle = random.chance(0.5) ? 0 : random.between(0, 3);
  for (Slice& slice : slices) {
    const double between = random.chance(0.6) ? 0 : random.chance(0.5) ? random.between(0, 0.5) : small(random, 3, 15);
    const double shift = random.chance(0.5) ? 0 : random.between(-1, 1);
    std::vector<double> heights{0};
    for (int r = 0; r < right; ++r) heights.push_back(heights.back() + random.between(0.1, 1));
    const double top = heights.back();
    add_ring(
        slice, 1,
        turned(box_of({-2 + shift, random.chance(0.5) ? 0.0 : -0.3}, {shift, random.chance(0.5) ? top : top + 0.4}),
               angle));
    for (int r = 0; r < right; ++r)
      add_ring(
          slice, 2 + r % 3,
          turned(box_of({shift + between, heights[std::size_t(r)]}, {shift + 2, heights[std::size_t(r + 1)]}), angle));
    if (random.chance(0.5)) add_ring(slice, 5, turned(box_of({shift, 0}, {shift + between, top}), angle));
  }
  return stack_slices(random, slices);
}

/// The border of one drawn again by its neighbour, off by nothing or a few units in the last place, with points left
/// out or added.
ContourStack nearly_shared(RandomNumbers& random, int points) {
  const int count = random.whole(2, 3), each = std::max(3, points / count / 4);
  const int reach = one_of(random, {0, 1, 3, 1000, 1 << 24});
  std::vector<Slice> slices(std::size_t(count), Slice{});
  for (Slice& slice : slices) {
    Ring border;
    for (int i = 0; i <= each; ++i) border.push_back({random.between(-0.3, 0.3), 0.1 * i});
    Ring left{{-2, 0.1 * each}, {-2, 0}}, right{{2, 0}, {2, 0.1 * each}};
    left.insert(left.end(), border.begin(), border.end());
    const bool halves = random.chance(0.5);
    for (auto p = border.rbegin(); p != border.rend(); ++p) {
      right.push_back({steps_from(p->x, random.whole(-reach, reach)), steps_from(p->y, random.whole(-reach, reach))});
      if (halves && p + 1 != border.rend()) right.push_back({(p->x + p[1].x) / 2, (p->y + p[1].y) / 2});
    }
    add_ring(slice, 1, left);
    add_ring(slice, 2, right);
    if (random.chance(0.4)) add_ring(slice, 3, box_of({-0.2, 0.1}, {0.2, 0.1 * each - 0.05}));
  }
  return stack_slices(random, slices);
}

}  // namespace

const std::vector<NamedPartitionMaker>& border_makers() {
  static const std::vector<NamedPartitionMaker> makers{{"cells", cells},         {"lattice", lattice},
                                                       {"sectors", sectors},     {"checkerboard", checkerboard},
                                                       {"junctions", junctions}, {"nearly-shared", nearly_shared}};
  return makers;
}

}  // namespace odontoscope::test
