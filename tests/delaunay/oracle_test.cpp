// The oracle, tested on solids made by hand: it must certify a right one and see each way of being wrong.

#include "tests/support/oracle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/shapes.h"

namespace odontoscope::test {
namespace {

/// Boundary and report by the library's own inspection, since the oracle compares with them.
void finish(Solid& solid) {
  solid.surface = {};
  std::vector<Triangle> faces;
  for (const Tetrahedron& t : solid.tetrahedra.tetrahedra)
    for (const auto& f : outward_face) {
      Triangle face{t[std::size_t(f[0])], t[std::size_t(f[1])], t[std::size_t(f[2])]};
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      const auto twin = std::find(faces.begin(), faces.end(), Triangle{face[0], face[2], face[1]});
      if (twin != faces.end())
        faces.erase(twin);
      else
        faces.push_back(face);
    }
  std::vector<PointIndex> number(solid.tetrahedra.points.size(), 0);
  for (const Triangle& face : faces)
    for (PointIndex v : face) number[v] = 1;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] == 1) {
      number[v] = PointIndex(solid.surface.points.size());
      solid.surface.points.push_back(solid.tetrahedra.points[v]);
    }
  for (const Triangle& f : faces) solid.surface.triangles.push_back({number[f[0]], number[f[1]], number[f[2]]});
  solid.report = inspect(solid.surface);
  for (Shell& shell : solid.report.shells) shell.structure = solid.structure;
  solid.tetrahedra.labels.assign(solid.tetrahedra.tetrahedra.size(), 1);
}

const Ring triangle{{0, 0}, {2, 0}, {0, 2}};
const ContourStack prism_stack = stack_of({{triangle}, {triangle}});

Solid prism() {
  Solid solid{"tooth", {}, {}, {}};
  for (double z : {0.0, spacing})
    for (Point2 p : triangle) solid.tetrahedra.points.push_back({p.x, p.y, z});
  solid.tetrahedra.tetrahedra = {{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}};
  // (1,2,3,4): det(2-1, 3-1, 4-1) decides; order each so that it is positive.
  for (Tetrahedron& t : solid.tetrahedra.tetrahedra) {
    const auto& p = solid.tetrahedra.points;
    const auto d = [&](PointIndex v) { return Point3{p[v].x - p[t[0]].x, p[v].y - p[t[0]].y, p[v].z - p[t[0]].z}; };
    const Point3 u = d(t[1]), v = d(t[2]), w = d(t[3]);
    const double det = u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
    if (det < 0) std::swap(t[2], t[3]);
  }
  finish(solid);
  return solid;
}

bool finds(const Solid& solid, const ContourStack& stack, const std::string& fault) {
  const Verdict verdict = judge(solid, stack);
  const bool found = std::any_of(verdict.faults.begin(), verdict.faults.end(),
                                 [&](const std::string& line) { return line.find(fault) != std::string::npos; });
  if (!found) ADD_FAILURE() << "not found: " << fault << "\nbut:\n" << verdict.in_words();
  return found;
}

TEST(Oracle, CertifiesAPrism) {
  const Verdict verdict = judge(prism(), prism_stack);
  EXPECT_TRUE(verdict.certified()) << verdict.in_words();
  ASSERT_EQ(verdict.shells.size(), 1u);
  EXPECT_EQ(verdict.shells[0].kind, Shell::Kind::external);
  EXPECT_EQ(verdict.shells[0].genus, 0);
  EXPECT_DOUBLE_EQ(verdict.shells[0].volume, 2 * spacing);
}

TEST(Oracle, SeesAnInvertedTetrahedron) {
  Solid solid = prism();
  std::swap(solid.tetrahedra.tetrahedra[1][0], solid.tetrahedra.tetrahedra[1][1]);
  EXPECT_TRUE(finds(solid, prism_stack, "an inverted tetrahedron"));
  EXPECT_TRUE(finds(solid, prism_stack, "two tetrahedra on one side of a face"));
}

TEST(Oracle, SeesAMissingTetrahedron) {
  Solid solid = prism();
  solid.tetrahedra.tetrahedra.erase(solid.tetrahedra.tetrahedra.begin());
  EXPECT_TRUE(finds(solid, prism_stack, "the surface is not the boundary"));
  finish(solid);
  EXPECT_TRUE(finds(solid, prism_stack, "a contour that is not an outline of the solid"));
}

TEST(Oracle, SeesATetrahedronTwice) {
  Solid solid = prism();
  solid.tetrahedra.tetrahedra.push_back(solid.tetrahedra.tetrahedra[0]);
  solid.tetrahedra.labels.push_back(1);
  EXPECT_TRUE(finds(solid, prism_stack, "two tetrahedra on one side of a face"));
}

TEST(Oracle, SeesAFlippedTriangleOfTheSurface) {
  Solid solid = prism();
  std::swap(solid.surface.triangles[3][0], solid.surface.triangles[3][1]);
  EXPECT_TRUE(finds(solid, prism_stack, "the surface is not the boundary"));
}

TEST(Oracle, SeesAMovedPoint) {
  Solid solid = prism();
  solid.tetrahedra.points[1].x = solid.surface.points[1].x = 2.0000000000000004;
  EXPECT_TRUE(finds(solid, prism_stack, "a contour that is not an outline of the solid"));
}

TEST(Oracle, SeesAContourThatIsNotThere) {
  const ContourStack more = stack_of({{triangle, rectangle({5, 5}, {6, 6})}, {triangle}});
  EXPECT_TRUE(finds(prism(), more, "a contour that is not an outline of the solid"));
  const ContourStack less = stack_of({{triangle}, {}});
  EXPECT_TRUE(finds(prism(), less, "an outline in a slice's plane that is no contour"));
}

TEST(Oracle, SeesACrossedSlice) {
  ContourStack stack = prism_stack;
  stack.slices.push_back({spacing / 2, {}});
  EXPECT_TRUE(finds(prism(), stack, "a tetrahedron that crosses a slice"));
}

/// Two prisms as one solid: the second's points mirrored into `place`, points in one place shared.
Solid two_prisms(auto place) {
  Solid solid = prism();
  const Solid one = solid;
  std::vector<PointIndex> number;
  for (Point3 p : one.tetrahedra.points) {
    const Point3 moved = place(p);
    auto& points = solid.tetrahedra.points;
    const auto found = std::find(points.begin(), points.end(), moved);
    number.push_back(PointIndex(found - points.begin()));
    if (found == points.end()) points.push_back(moved);
  }
  for (const Tetrahedron& t : one.tetrahedra.tetrahedra)
    solid.tetrahedra.tetrahedra.push_back({number[t[0]], number[t[1]], number[t[2]], number[t[3]]});
  finish(solid);
  return solid;
}

TEST(Oracle, SeesASharedEdge) {
  // Turned half round the z axis: the two prisms share the edge over the origin.
  const Solid solid = two_prisms([](Point3 p) { return Point3{p.x == 0 ? 0 : -p.x, p.y == 0 ? 0 : -p.y, p.z}; });
  EXPECT_TRUE(finds(solid, prism_stack, "an edge with more than one fan of tetrahedra"));
  EXPECT_TRUE(finds(solid, prism_stack, "a surface edge that is not manifold"));
}

TEST(Oracle, SeesASharedVertex) {
  // Sheared after turning, so that only the point at the origin of the lower slice is shared.
  const Solid solid = two_prisms([](Point3 p) {
    return Point3{-p.x - 0.1 * p.z, p.y == 0 ? 0 : -p.y, p.z == 0 ? 0.0 : p.z};
  });
  EXPECT_TRUE(finds(solid, prism_stack, "a vertex whose tetrahedra form more than one cone"));
  EXPECT_TRUE(finds(solid, prism_stack, "a surface vertex with more than one fan"));
}

TEST(Oracle, SeesOverlappingPieces) {
  const Solid solid = two_prisms([](Point3 p) { return Point3{p.x + 0.5, p.y + 0.25, p.z}; });
  EXPECT_TRUE(finds(solid, prism_stack, "the surface meets itself"));
}

TEST(Oracle, SeesOnePieceInsideAnother) {
  // No faces meet, but the small prism's space is covered twice.
  const Solid solid = two_prisms([](Point3 p) { return Point3{0.5 + p.x / 8, 0.5 + p.y / 8, spacing / 4 + p.z / 4}; });
  EXPECT_TRUE(finds(solid, prism_stack, "shells that are not nested"));
}

TEST(Oracle, SeesAnUnusedPoint) {
  Solid solid = prism();
  solid.tetrahedra.points.push_back({1, 1, spacing / 2});
  EXPECT_TRUE(finds(solid, prism_stack, "a point that no tetrahedron uses"));
}

TEST(Oracle, SeesTwoPointsInOnePlace) {
  Solid solid = prism();
  solid.tetrahedra.points.push_back(solid.tetrahedra.points[3]);
  for (PointIndex& v : solid.tetrahedra.tetrahedra[2])
    if (v == 3) v = 6;
  finish(solid);
  EXPECT_TRUE(finds(solid, prism_stack, "two points in one place"));
}

TEST(Oracle, SeesAWrongReport) {
  Solid solid = prism();
  solid.report.shells[0].genus = 1;
  EXPECT_TRUE(finds(solid, prism_stack, "the report's shells"));
}

TEST(Oracle, ComparesLinksWithPieces) {
  Reconstruction result;
  result.solids = {prism()};
  result.certified = true;
  result.topology = {{"tooth", 0, {2, 0, 0}, {1, 0, 0}, 0}};
  EXPECT_EQ(faults_of(result, prism_stack),
            (std::vector<std::string>{
                "tooth: regions that no link joins lie in one piece, 1 times, first: slices 0, 1, contours 0, 0"}));
  result.links = {{{"tooth", 0, 0, 0, true}, LinkCriterion::medial}};
  result.topology[0].implied.pieces = 1;
  EXPECT_EQ(faults_of(result, prism_stack), std::vector<std::string>{});
}

TEST(Oracle, ComparesTopologyWithWhatIsTold) {
  Reconstruction result;
  result.solids = {prism()};
  result.certified = true;
  result.links = {{{"tooth", 0, 0, 0, true}, LinkCriterion::medial}};
  const auto untrue = [&] { return faults_of(result, prism_stack); };
  EXPECT_EQ(untrue(),
            std::vector<std::string>{"untrue topology, tooth, slab 0: the result does not tell its topology"});
  result.topology = {{"tooth", 0, {1, 0, 0}, {1, 1, 0}, 0}};
  EXPECT_EQ(untrue(), std::vector<std::string>{"untrue topology, tooth, slab 0: found 1 pieces, 0 handles, 0 bubbles, "
                                               "told are 1 pieces, 1 handles, 0 bubbles"});
}

}  // namespace
}  // namespace odontoscope::test
