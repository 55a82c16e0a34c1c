// Every format that we both write and read: written, read back and compared, over all named shapes. docs/formats.md
// ("What is read and written") says what each must keep.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "recon/delaunay/reconstruct.h"
#include "recon/exchange/cut_surfaces.h"
#include "recon/formats/read_mesh.h"
#include "recon/formats/single_precision.h"
#include "recon/input/links_json.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "recon/output/model_file.h"
#include "tests/input/same_stack.h"
#include "tests/support/shapes.h"

namespace odontoscope {
namespace {

/// A triangle by the places of its corners, its least corner first: as it is whatever the numbering, and told from its
/// mirror image.
using PlacedTriangle = std::array<std::array<double, 3>, 3>;
using Places = std::multiset<PlacedTriangle>;

void add(Places& places, const std::vector<Point3>& points, const std::vector<Triangle>& triangles) {
  for (const Triangle& t : triangles) {
    PlacedTriangle placed;
    for (std::size_t k = 0; k < 3; ++k) placed[k] = {points[t[k]].x, points[t[k]].y, points[t[k]].z};
    std::rotate(placed.begin(), std::min_element(placed.begin(), placed.end()), placed.end());
    places.insert(placed);
  }
}

Places places_of(const std::vector<NamedMesh>& meshes) {
  Places places;
  for (const NamedMesh& mesh : meshes) add(places, mesh.surface.points, mesh.surface.triangles);
  return places;
}

/// The model's triangles, each coordinate made by `stored`, which gives the place that a format keeps of a point.
template <class Stored>
Places places_of(const Reconstruction& model, Stored stored) {
  Places places;
  for (const Solid& solid : model.solids) add(places, stored(solid.surface.points), solid.surface.triangles);
  return places;
}

std::vector<Point3> as_they_are(const std::vector<Point3>& points) { return points; }
/// STL: floats of millimetres.
std::vector<Point3> as_floats(const std::vector<Point3>& points) {
  std::vector<Point3> stored;
  for (const FloatPoint& p : distinct_floats(points, 1)) stored.push_back({p[0], p[1], p[2]});
  return stored;
}
/// GLB: floats of metres, read as doubles of millimetres.
std::vector<Point3> as_floats_of_metres(const std::vector<Point3>& points) {
  std::vector<Point3> stored;
  for (const FloatPoint& p : distinct_floats(points, 1e-3))
    stored.push_back({1000.0 * p[0], 1000.0 * p[1], 1000.0 * p[2]});
  return stored;
}

std::string bytes_of(const Reconstruction& model, const std::string& ending) {
  return model_file(model, "model" + ending).bytes;
}

class RoundTrip : public ::testing::TestWithParam<test::NamedStack> {
 protected:
  ContourStack stack = ordered(GetParam().stack).stack;
  Reconstruction model = reconstruct(stack);
};

TEST_P(RoundTrip, StackKeepsEveryBit) {
  const std::string text = to_json(stack);
  const ContourStack again = parse_stack(text, "again");
  EXPECT_EQ(to_json(again), text);
  ASSERT_NO_FATAL_FAILURE(test::expect_same_slices(again, stack));
}

TEST_P(RoundTrip, LinksAreTheSame) {
  std::vector<ReportedLink> reported;
  std::vector<Link> made;
  for (const MadeLink& link : model.links) {
    reported.push_back({link.link, name(link.criterion)});
    made.push_back(link.link);
  }
  const std::string text = links_to_json(reported);
  EXPECT_EQ(parse_links(text, "again"), made);
}

TEST_P(RoundTrip, PlyAndObjKeepEveryBit) {
  const Places expected = places_of(model, as_they_are);
  EXPECT_EQ(places_of(parse_ply(bytes_of(model, ".ply"), "model")), expected);
  EXPECT_EQ(places_of(parse_obj(bytes_of(model, ".obj"), "model")), expected);
}

TEST_P(RoundTrip, StlAndGlbKeepFloats) {
  EXPECT_EQ(places_of(parse_stl(bytes_of(model, ".stl"), "model")), places_of(model, as_floats));
  EXPECT_EQ(places_of(parse_glb(bytes_of(model, ".glb"), "model")), places_of(model, as_floats_of_metres));
  EXPECT_EQ(places_of(parse_gltf(bytes_of(model, ".gltf"), "model")), places_of(model, as_floats_of_metres));
}

std::string decoded(const std::string& base64) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : base64.substr(0, base64.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(letters.find(c));
    held += 6;
    if (held >= 8) bytes += static_cast<char>(bits >> (held -= 8) & 0xff);
  }
  return bytes;
}

/// .gltf is not read by us: it holds what the GLB does, which is.
TEST_P(RoundTrip, GltfIsTheGlbAsText) {
  const std::string glb = bytes_of(model, ".glb");
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  nlohmann::json binary = nlohmann::json::parse(glb.substr(20, length)),
                 text = nlohmann::json::parse(bytes_of(model, ".gltf"));
  const std::string uri = text["buffers"][0]["uri"];
  text["buffers"][0].erase("uri");
  EXPECT_EQ(text, binary);
  const std::string buffer = decoded(uri.substr(uri.find(',') + 1));
  EXPECT_EQ(glb.substr(28 + length, buffer.size()), buffer);
}

ContourStack cut(const Reconstruction& model, const std::vector<double>& heights) {
  std::vector<NamedMesh> surfaces;
  for (const Solid& solid : model.solids) surfaces.push_back({solid.structure, solid.surface});
  return cut_surfaces(surfaces, heights, "model").stack;
}

/// Sections at the slices' own heights, reconstructed and cut again.
TEST_P(RoundTrip, SectionsOfSectionsAreTheSame) {
  std::vector<double> heights;
  for (const Slice& slice : stack.slices) heights.push_back(slice.z);
  const ContourStack first = cut(model, heights);
  EXPECT_EQ(to_json(cut(reconstruct(first), heights)), to_json(first));
}

INSTANTIATE_TEST_SUITE_P(Shapes, RoundTrip, ::testing::ValuesIn(test::all_shapes()), [](const auto& shape) {
  std::string name = shape.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '-'; }, '_');
  return name;
});

}  // namespace
}  // namespace odontoscope
