// What the certificate says, against stacks of which it is known what they leave open.

#include "recon/delaunay/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/delaunay/difference_place.h"
#include "recon/sample/sample_tooth.h"
#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

std::vector<AttentionKind> kinds(const Reconstruction& made) {
  std::vector<AttentionKind> all;
  for (const Attention& item : made.attention) all.push_back(item.kind);
  return all;
}

std::string told(const Reconstruction& made) {
  std::string all = headline(made) + "\n";
  for (const Attention& item : made.attention) all += in_words(item) + "\n";
  return all;
}

/// What is written here holds for the narrower ways to link and to fill slabs, whatever the defaults are.
Reconstruction made_of(const ContourStack& stack, const std::vector<Link>& links = {},
                       Between between = Between::delaunay) {
  return reconstruct(stack, {.correspondence = Correspondence::medial, .between = between, .links = links});
}

constexpr std::size_t tall = 5;  // slices: no loose piece

/// Rings through so many slices each, one group over the other.
ContourStack storeys(const std::vector<std::vector<Ring>>& groups) {
  std::vector<std::vector<Ring>> slices;
  for (const std::vector<Ring>& group : groups) slices.insert(slices.end(), tall, group);
  return stack_of(slices);
}

/// A canal's piece that stands straight, and another beside its upper end: one canal with a bend, or two.
ContourStack broken_canal() { return storeys({{circle(1)}, {circle(1, {2.5, 0})}}); }

/// The same with one candidate on either side, equally far.
ContourStack canal_with_two_ways_on() { return storeys({{circle(1)}, {circle(1, {2.5, 0}), circle(1, {-2.5, 0})}}); }

/// A block with a wide chamber below and a narrow horn above that lies with its smaller part over the chamber: the roof
/// between may or may not close.
ContourStack chamber_under_horn() {
  const Ring block = rectangle({-6, -6}, {6, 6});
  return storeys({{block, circle(3)}, {block, circle(0.5, {3.2, 0})}});
}

/// The same without a horn: the roof closes, whatever.
ContourStack chamber_under_roof() {
  const Ring block = rectangle({-6, -6}, {6, 6});
  return storeys({{block, circle(3)}, {block}});
}

TEST(Verdict, OfSampleTeethIsGreen) {
  for (const ToothKind kind : {ToothKind::molar, ToothKind::premolar, ToothKind::incisor}) {
    const Reconstruction made = made_of(sample_tooth(kind), {}, Between::blended);
    EXPECT_EQ(verdict_of(made), Verdict::green) << told(made);
  }
}

/// Plain Delaunay gives the molar's dentine a handle too many in a fissure, so it is not among them.
TEST(Verdict, IsGreenWhereOverhangsWereTrimmed) {
  for (const ToothKind kind : {ToothKind::premolar, ToothKind::incisor}) {
    const Reconstruction made = made_of(sample_tooth(kind));
    ASSERT_GT(made.counts.trimmed, 0u);
    EXPECT_EQ(verdict_of(made), Verdict::green) << told(made);
  }
}

TEST(Verdict, IsGreenWhereNothingIsOpen) {
  for (const ContourStack& stack :
       {storeys({{circle(1)}}), shifted_circles(0.5), annulus_over_shifted_annulus(), chamber_under_roof()}) {
    const Reconstruction made = reconstruct(stack);
    EXPECT_EQ(verdict_of(made), Verdict::green) << told(made);
    EXPECT_EQ(headline(made).find("Green"), 0u);
  }
}

TEST(Verdict, IsRedWithoutASoundSurface) {
  Reconstruction made = reconstruct(shifted_circles(0.5));
  made.solids.front().report.boundary_edges = 3;
  EXPECT_EQ(verdict_of(made), Verdict::red);
  made = reconstruct(shifted_circles(0.5));
  made.certified = false;
  EXPECT_EQ(verdict_of(made), Verdict::red);
}

TEST(Verdict, IsAmberForASlabThatIsNotAsImpliedWhateverElse) {
  Reconstruction made = reconstruct(shifted_circles(0.5));
  made.topology.front().untrimmed.reset();
  made.topology.front().found.handles += 1;
  EXPECT_EQ(verdict_of(made), Verdict::amber);
}

TEST(LookHere, EndsThatFaceEachOtherAndTheLinkThatJoinsThem) {
  const ContourStack stack = broken_canal();
  const Reconstruction made = made_of(stack);
  ASSERT_EQ(kinds(made), std::vector{AttentionKind::gap}) << told(made);
  const Attention& item = made.attention.front();
  EXPECT_EQ(item.slice, tall - 1);
  EXPECT_EQ(item.last_slice, tall);
  EXPECT_EQ(item.z_lower, spacing * (tall - 1));
  EXPECT_NEAR(item.place.x, 1.25, 1e-9);
  EXPECT_NEAR(item.place.z, spacing * (tall - 0.5), 1e-9);
  EXPECT_EQ(item.links, (std::vector<Link>{{"tooth", tall - 1, 0, 0, true}}));
  EXPECT_NE(item.remedy.find("--link tooth:4:0-0"), std::string::npos) << item.remedy;
  EXPECT_EQ(verdict_of(made), Verdict::amber);

  const Reconstruction joined = made_of(stack, item.links);
  EXPECT_EQ(verdict_of(joined), Verdict::green) << told(joined);
  EXPECT_EQ(joined.solids.front().report.shells.size(), 1u);
  std::vector<Link> apart = item.links;
  apart.front().connect = false;
  EXPECT_EQ(verdict_of(made_of(stack, apart)), Verdict::green) << "it was said that they are two";
}

TEST(LookHere, OfTwoEqualCandidatesEitherLinkDecides) {
  ContourStack turned = canal_with_two_ways_on();
  for (Slice& slice : turned.slices) slice.z = -slice.z;
  for (const ContourStack& stack : {canal_with_two_ways_on(), turned}) {
    const Reconstruction made = made_of(stack);
    ASSERT_EQ(kinds(made), std::vector{AttentionKind::gap}) << told(made);
    ASSERT_EQ(made.attention.front().links.size(), 2u);
    for (const Link& link : made.attention.front().links) {
      const Reconstruction joined = made_of(stack, {link});
      EXPECT_EQ(verdict_of(joined), Verdict::green) << told(joined);
      EXPECT_EQ(joined.solids.front().report.shells.size(), 2u);
    }
  }
}

/// A chamber and, far from it, a void that one slice alone shows: a piece of a canal, or a flaw.
ContourStack void_far_from_chamber() {
  const Ring block = rectangle({-6, -6}, {6, 6});
  ContourStack stack = storeys({{block}, {block, circle(2, {-3, 0})}, {block}});
  stack.slices[tall + 2] = stack_of({{block, circle(2, {-3, 0}), circle(0.3, {4, 0})}}).slices.front();
  stack.slices[tall + 2].z = (stack.slices[tall + 1].z + stack.slices[tall + 3].z) / 2;
  return stack;
}

TEST(LookHere, AVoidThatIsShutInBesideALargerOne) {
  const Reconstruction made = made_of(void_far_from_chamber());
  ASSERT_EQ(kinds(made), std::vector{AttentionKind::void_gap}) << told(made);
  EXPECT_EQ(made.attention.front().slice, tall + 2);
  EXPECT_NEAR(made.attention.front().place.x, 4, 0.01);
  ContourStack chamber = void_far_from_chamber();
  chamber.slices[tall + 2].contours.pop_back();
  EXPECT_EQ(verdict_of(made_of(chamber)), Verdict::green) << "a chamber that is shut in is none";
}

/// A fissure that narrows downwards, `last` wide where it is seen last, and a chamber below that lies partly under it.
ContourStack fissure_over_chamber(double last) {
  const Ring block = rectangle({-6, -6}, {6, 6}), chamber = rectangle({-4, -4}, {-0.1, 4}),
             above = rectangle({-4, -4}, {-1, 4});
  ContourStack stack = storeys({{block, chamber}, {block}});
  for (std::size_t k = 0; k < tall; ++k) {
    Slice& slice = stack.slices[tall + k];
    slice = stack_of({{block, above, circle(k == 0 ? last : 0.6, {k == 0 ? last - 0.3 : 0.3, 0})}}).slices.front();
    slice.z = spacing * static_cast<double>(tall + k);
  }
  return stack;
}

TEST(LookHere, TheBottomOfAFissureOverTheDentineIsNone) {
  const auto gaps = [](double last) {
    const Reconstruction made = made_of(fissure_over_chamber(last));
    const auto found = kinds(made);
    return std::count(found.begin(), found.end(), AttentionKind::void_gap);
  };
  EXPECT_EQ(gaps(0.3), 0) << "it is running out";
  EXPECT_EQ(gaps(0.58), 1) << "as wide as before";
}

TEST(LookHere, ARoofThatMayBeOpen) {
  const ContourStack stack = chamber_under_horn();
  const Reconstruction made = made_of(stack);
  ASSERT_EQ(kinds(made), std::vector{AttentionKind::void_gap}) << told(made);
  const Attention& item = made.attention.front();
  EXPECT_EQ(item.slice, tall - 1);
  EXPECT_TRUE(item.links.empty()) << "links are of material";
  EXPECT_NE(item.remedy.find("--correspondence overlap"), std::string::npos) << item.remedy;
  const Reconstruction joined =
      reconstruct(stack, {.correspondence = Correspondence::overlap, .between = Between::blended});
  EXPECT_EQ(verdict_of(joined), Verdict::green) << told(joined);
}

TEST(LookHere, EveryLinkThatIsGivenEndsItsItemOrLeavesFewer) {
  int tried = 0;
  for (const auto& [name, stack] : all_shapes())
    for (const Between between : {Between::delaunay, Between::blended}) {
      const Reconstruction made = made_of(stack, {}, between);
      for (const Attention& item : made.attention) {
        if (item.kind != AttentionKind::gap) continue;
        const Reconstruction joined = made_of(stack, {item.links.front()}, between);
        EXPECT_LT(joined.attention.size(), made.attention.size()) << name << "\n" << told(joined);
        ++tried;
      }
    }
  EXPECT_GE(tried, 4);
}

TEST(LookHere, FarEndsAreTwoThings) {
  const Reconstruction made = made_of(storeys({{circle(1)}, {circle(1, {5, 0})}}));
  EXPECT_EQ(verdict_of(made), Verdict::green) << told(made);
}

TEST(LookHere, APieceThatFewSlicesHold) {
  for (const std::size_t slices : {1, 2, 4}) {
    std::vector<std::vector<Ring>> rings(9, {circle(1)});
    for (std::size_t k = 0; k < slices; ++k) rings[3 + k].push_back(rectangle({6, 6}, {6.5, 6.5}));
    const Reconstruction made = made_of(stack_of(rings));
    if (slices > 3) {
      EXPECT_EQ(verdict_of(made), Verdict::green) << told(made);
      continue;
    }
    ASSERT_EQ(kinds(made), std::vector{AttentionKind::loose_piece}) << told(made);
    const Attention& item = made.attention.front();
    EXPECT_EQ(item.slice, 3u);
    EXPECT_EQ(item.last_slice, 2 + slices);
    EXPECT_NEAR(item.place.x, 6.25, 1e-9);
    // A plate reaches a quarter of a slab to either side; two equal squares make a column.
    const double volume = 0.25 * spacing * (slices == 1 ? 0.5 : 1.0);
    EXPECT_NE(item.seen.find(slices == 1 ? "0.062 mm^3" : "0.12 mm^3"), std::string::npos)
        << item.seen << " " << volume;
  }
}

TEST(Changes, TellWhereOverhangsWereTrimmed) {
  const Reconstruction made = made_of(ring_over_crescent());
  ASSERT_GT(made.counts.trimmed, 0u);
  std::size_t trimmed = 0;
  for (const SlabChange& change : made.changes) {
    if (change.kind != SlabChange::Kind::trimmed) continue;
    trimmed += change.count;
    EXPECT_GT(change.volume, 0);
    EXPECT_GE(change.place.z, change.z_lower);
    EXPECT_LE(change.place.z, change.z_upper);
  }
  EXPECT_EQ(trimmed, made.counts.trimmed);
}

/// Unit cubes of a block, each cut into six tetrahedra about a diagonal.
struct Cubes {
  std::vector<Point3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Triangle> boundary;

  explicit Cubes(const std::vector<std::array<int, 3>>& cubes) {
    constexpr int side = 12;
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) points.push_back({double(x), double(y), double(z)});
    constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const auto& cube : cubes)
      for (const auto& order : orders) {
        std::array<int, 3> at = cube;
        Tetrahedron tet{};
        const auto number = [&] { return PointIndex(at[0] + side * (at[1] + side * at[2])); };
        tet[0] = number();
        for (int i = 0; i < 3; ++i) {
          ++at[order[i]];
          tet[i + 1] = number();
        }
        if (delaunay::mass_of(points, {tet}).volume < 0) std::swap(tet[0], tet[1]);
        tetrahedra.push_back(tet);
      }
    for (const Tetrahedron& tet : tetrahedra)
      for (const auto& f : outward_face) {
        const Triangle face{tet[f[0]], tet[f[1]], tet[f[2]]};
        const auto same = [&](Triangle other) {
          Triangle a = face;
          std::sort(a.begin(), a.end());
          std::sort(other.begin(), other.end());
          return a == other;
        };
        const auto twin = std::find_if(boundary.begin(), boundary.end(), same);
        if (twin == boundary.end())
          boundary.push_back(face);
        else
          boundary.erase(twin);
      }
  }
};

std::vector<std::array<int, 3>> block(int x, int y, int z) {
  std::vector<std::array<int, 3>> cubes;
  for (int i = 0; i < x; ++i)
    for (int j = 0; j < y; ++j)
      for (int k = 0; k < z; ++k) cubes.push_back({i, j, k});
  return cubes;
}

void expect_near(const Point3& place, const Point3& truth, double most) {
  EXPECT_LE(std::hypot(place.x - truth.x, place.y - truth.y, place.z - truth.z), most)
      << place.x << " " << place.y << " " << place.z;
}

TEST(DifferencePlace, OfATunnelThatNoSliceHas) {
  auto cubes = block(5, 9, 1);
  std::erase_if(cubes, [](const auto& c) {
    return c == std::array{2, 6, 0} || (c[0] == 2 && c[1] >= 1 && c[1] <= 3);
  });  // one small, one long
  const Cubes solid(cubes);
  const std::vector<Ring> implied_hole{rectangle({2, 1}, {3, 4})};
  expect_near(delaunay::place_of_difference({solid.points, solid.tetrahedra, solid.boundary, implied_hole}, {1, 1, 0},
                                            {1, 2, 0}),
              {2.5, 6.5, 0.5}, 0.6);
  const std::vector<Ring> other_hole{rectangle({2, 6}, {3, 7})};
  expect_near(
      delaunay::place_of_difference({solid.points, solid.tetrahedra, solid.boundary, other_hole}, {1, 1, 0}, {1, 2, 0}),
      {2.5, 2.5, 0.5}, 0.9);
}

TEST(DifferencePlace, OfABubbleAndOfALoosePiece) {
  auto hollow = block(3, 3, 5);
  std::erase(hollow, std::array{1, 1, 3});
  const Cubes shut(hollow);
  expect_near(delaunay::place_of_difference({shut.points, shut.tetrahedra, shut.boundary, {}}, {1, 0, 0}, {1, 0, 1}),
              {1.5, 1.5, 3.5}, 1e-9);
  auto two = block(3, 3, 1);
  two.push_back({8, 8, 0});
  const Cubes loose(two);
  expect_near(delaunay::place_of_difference({loose.points, loose.tetrahedra, loose.boundary, {}}, {1, 0, 0}, {2, 0, 0}),
              {8.5, 8.5, 0.5}, 1e-9);
}

TEST(Changes, TellInterpolatedSlabs) {
  const Reconstruction made = made_of(star_over_turned_star(), {}, Between::blended);
  std::size_t interpolated = 0;
  for (const SlabTopology& slab : made.topology) interpolated += slab.interpolated;
  ASSERT_GT(interpolated, 0u);
  ASSERT_EQ(made.changes.size(), 1u);
  EXPECT_EQ(made.changes.front().kind, SlabChange::Kind::interpolated);
  EXPECT_EQ(made.changes.front().count, interpolated);
  EXPECT_NEAR(made.changes.front().place.x, 0, 0.05);
  EXPECT_GT(made.changes.front().volume, 1);
  EXPECT_NE(in_words(made.changes).find("1 slab through"), std::string::npos) << in_words(made.changes);
}

TEST(OptionFor, IsQuotedForAShellWhereNeeded) {
  EXPECT_EQ(option_for({"pulp", 12, 0, 3, true}), "--link pulp:12:0-3");
  EXPECT_EQ(option_for({"it's a:b", 1, 2, 3, false}), "--unlink 'it'\\''s a:b:1:2-3'");
}

}  // namespace
}  // namespace odontoscope::test
