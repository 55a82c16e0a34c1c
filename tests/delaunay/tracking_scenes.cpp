#include "tests/delaunay/tracking_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/core/union_find.h"
#include "tests/support/random_numbers.h"

namespace odontoscope::test {

using namespace delaunay;

namespace {

std::vector<RegionLink> region_witnesses(const ConformedSlice& lower, const ConformedSlice& upper) {
  if (lower.regions() == 0 || upper.regions() == 0) return {};
  return witnessed_links(triangulate_slab(lower.planar, upper.planar), lower.planar, upper.planar,
                         Correspondence::overlap);
}

std::vector<RegionLink> void_witnesses(const ConformedSlice& lower, const ConformedSlice& upper) {
  SlabTetrahedra tetrahedra;
  if (lower.regions() > 0 && upper.regions() > 0) tetrahedra = triangulate_slab(lower.planar, upper.planar);
  return witnessed_void_links(tetrahedra, lower.planar, upper.planar, voids_in(lower.planar, lower, voids_of(lower)),
                              voids_in(upper.planar, upper, voids_of(upper)), Correspondence::overlap);
}

}  // namespace

Ring disc_ring(const Disc& disc) { return regular_polygon(24, disc.radius, disc.at, 0.1); }

ContourStack stack_of_discs(const Scene& scene, double height) {
  ContourStack stack;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    stack.slices.push_back({height * double(k), {}});
    for (const Disc& disc : scene[k]) stack.slices.back().contours.push_back({"tooth", disc_ring(disc)});
  }
  return stack;
}

ContourStack stack_of_holes(const Scene& scene, double height) {
  ContourStack stack = stack_of_discs(scene, height);
  for (Slice& slice : stack.slices)
    slice.contours.insert(slice.contours.begin(), {"tooth", rectangle({-20, -20}, {40, 20})});
  return stack;
}

Scene straight(int slices, double step, double radius) {
  Scene scene;
  for (int k = 0; k < slices; ++k) scene.push_back({{{step * k, 0}, radius}});
  return scene;
}

Scene parallel_canals(double gap) {
  Scene scene;
  for (int k = 0; k < 8; ++k) scene.push_back({{{cut * k, 0}, thin}, {{cut * k + gap, 0}, thin}});
  return scene;
}

Scene passing_canals() {
  Scene scene;
  for (int k = 0; k < 9; ++k) scene.push_back({{{cut * (k - 4), 0.2}, thin}, {{-cut * (k - 4), -0.2}, thin}});
  return scene;
}

Scene canal_that_ends() {
  Scene scene;
  for (int k = 0; k < 10; ++k) {
    if (k < 5)
      scene.push_back({{{cut * k, 0}, thin}});
    else
      scene.push_back({{{1.0 + cut * (k - 5), 0.8}, thin}});
  }
  return scene;
}

Scene fork() {
  Scene scene;
  for (int k = 0; k < 8; ++k) {
    const double away = cut * (k - 3);
    if (k <= 3)
      scene.push_back({{{0, 0}, thin}});
    else
      scene.push_back({{{away, 0}, thin}, {{-away, 0}, thin}});
  }
  return scene;
}

Scene accessory_canal() {
  Scene scene;
  for (int k = 0; k < 10; ++k) {
    scene.push_back({{{0, 0}, 1.5}});
    if (k < 5) scene.back().push_back({{1.9 + cut * (4 - k), 0}, thin});
  }
  return scene;
}

Scene leaning_cusps() {
  Scene scene{{{{0, 0}, 3}}, {{{0, 0}, 2.9}}};
  for (int k = 0; k < 6; ++k) {
    scene.emplace_back();
    for (const double side : {-1.0, 1.0}) {
      const double height = (side < 0 ? 2.0 : 3.2) - cut * k;
      if (height > 0) scene.back().push_back({{side * (1.4 - 0.15 * k), 0}, 0.7 * std::sqrt(height / 3.2)});
    }
  }
  return scene;
}

Scene apex_beside_root() {
  Scene scene;
  for (int k = 0; k < 8; ++k) {
    scene.push_back({{{0, 0}, 1}});
    const double radius = 0.6 - 0.13 * k;
    if (radius > 0) scene.back().push_back({{2.0 - 0.2 * k, 0}, radius});
  }
  return scene;
}

Scene tip_that_leans_on_a_column() {
  return {{{{0, 0}, 1}, {{1.85, 0}, 0.5}}, {{{0, 0}, 1}, {{1.4, 0}, 0.35}}, {{{0, 0}, 1}}, {{{0, 0}, 1}}};
}

Scene strewn(std::uint64_t seed, int slices, int islands) {
  RandomNumbers random(seed);
  Scene scene;
  for (int k = 0; k < slices; ++k) {
    scene.emplace_back();
    while (int(scene.back().size()) < islands) {
      const Disc disc{{random.between(-4, 4), random.between(-4, 4)}, random.between(0.1, 0.25)};
      const auto near = [&](const Disc& other) {
        return std::hypot(disc.at.x - other.at.x, disc.at.y - other.at.y) < 1.2 * (disc.radius + other.radius);
      };
      if (std::none_of(scene.back().begin(), scene.back().end(), near)) scene.back().push_back(disc);
    }
  }
  return scene;
}

Tracked tracked(const ContourStack& stack, Correspondence criterion, const std::map<std::size_t, ShapePairs>& apart) {
  const auto slices = conformed(stack);
  Tracked result;
  for (const ConformedSlice& slice : slices) result.slices.push_back(region_shapes(slice));
  for (std::size_t k = 0; k + 1 < slices.size(); ++k) {
    result.slabs.push_back(links_by(region_witnesses(slices[k], slices[k + 1]), criterion));
    if (apart.contains(k)) result.slabs.back().apart = apart.at(k);
  }
  result.tracking = track(result.slices, result.slabs);
  return result;
}

Tracked tracked_voids(const ContourStack& stack) {
  const auto slices = conformed(stack);
  Tracked result;
  for (const ConformedSlice& slice : slices) result.slices.push_back(void_shapes(slice, voids_of(slice)));
  for (std::size_t k = 0; k + 1 < slices.size(); ++k)
    result.slabs.push_back(links_by(void_witnesses(slices[k], slices[k + 1]), Correspondence::medial));
  result.tracking = track(result.slices, result.slabs);
  return result;
}

void expect_one_chain(const Tracked& made, std::size_t slices) {
  EXPECT_EQ(made.pieces(), 1u);
  std::set<std::size_t> slabs;
  std::size_t bounded = 0;
  for (const auto& [k, a, b] : made.links())
    if (!made.slices[k].shapes[a].unbounded) slabs.insert(k), ++bounded;
  EXPECT_EQ(slabs.size(), slices - 1);
  EXPECT_EQ(bounded, slices - 1);
}

std::size_t Tracked::count(TrackedBy by) const {
  std::size_t found = 0;
  for (const auto& links : tracking.links)
    found += std::count_if(links.begin(), links.end(), [by](const TrackedLink& link) { return link.by == by; });
  return found;
}

std::size_t Tracked::count() const {
  return count(TrackedBy::drift) + count(TrackedBy::entry) + count(TrackedBy::overlap) + count(TrackedBy::beside);
}

std::set<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> Tracked::links() const {
  std::set<std::tuple<std::size_t, std::uint32_t, std::uint32_t>> all;
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    for (const RegionLink& link : slabs[k].made) all.insert({k, link.lower, link.upper});
    for (const TrackedLink& link : tracking.links[k]) all.insert({k, link.lower, link.upper});
  }
  return all;
}

std::size_t Tracked::pieces() const {
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const ShapeSlice& slice : slices) {
    first.push_back(count);
    count += slice.shapes.size();
  }
  UnionFind groups(count);
  for (const auto& [k, a, b] : links())
    if (!slices[k].shapes[a].unbounded && !slices[k + 1].shapes[b].unbounded)
      groups.join(std::uint32_t(first[k] + a), std::uint32_t(first[k + 1] + b));
  std::set<std::uint32_t> heads;
  for (std::size_t k = 0; k < slices.size(); ++k)
    for (std::uint32_t i = 0; i < slices[k].shapes.size(); ++i)
      if (!slices[k].shapes[i].unbounded) heads.insert(groups.find(std::uint32_t(first[k] + i)));
  return heads.size();
}

}  // namespace odontoscope::test
