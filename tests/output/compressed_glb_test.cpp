// GLB compressed with meshoptimizer: nothing is lost on the way through the file, and what lies about itself is
// refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "recon/core/error.h"
#include "recon/formats/little_endian.h"
#include "recon/formats/read_mesh.h"
#include "recon/formats/write_glb.h"
#include "tests/mesh/shapes.h"
#include "tests/output/models.h"

namespace odontoscope {
namespace {

using nlohmann::json;

/// Triangles by the places of their corners, each turned so that its least comes first: the same surface, the same
/// list.
std::vector<std::array<Point3, 3>> places(const SurfaceMesh& surface) {
  const auto less = [](const Point3& a, const Point3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::vector<std::array<Point3, 3>> all;
  for (const Triangle& t : surface.triangles) {
    std::array<Point3, 3> corners{surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), less), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
  });
  return all;
}

std::string small() { return glb_bytes(models::tooth_and_enamel(), {.compressed = true}); }

json document_of(const std::string& bytes) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof(length));
  return json::parse(bytes.substr(20, length));
}

std::string with_document(const std::string& bytes, const json& document) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof(length));
  std::string text = document.dump(), made = "glTF";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  append(made, std::uint32_t{2});
  append(made, static_cast<std::uint32_t>(bytes.size() - length + text.size()));
  append(made, static_cast<std::uint32_t>(text.size()));
  return made + bytes.substr(16, 4) + text + bytes.substr(20 + length);
}

std::string cause_of(const std::string& bytes) {
  try {
    parse_glb(bytes, "file");
    return "accepted";
  } catch (const InputError& error) {
    return error.cause();
  }
}

/// What is said of the positions, or of the corners, of the first mesh changed.
std::string cause_with(const char* of, const std::function<void(json& view, json& compression)>& change) {
  const std::string bytes = small();
  json document = document_of(bytes);
  const json& primitive = document["meshes"][0]["primitives"][0];
  const json& accessor = of == std::string("indices") ? primitive[of] : primitive["attributes"][of];
  json& view =
      document["bufferViews"][document["accessors"][accessor.get<std::size_t>()]["bufferView"].get<std::size_t>()];
  change(view, view["extensions"]["EXT_meshopt_compression"]);
  return cause_of(with_document(bytes, document));
}

TEST(CompressedGlb, LosesNothing) {
  const Reconstruction model = models::tooth_and_enamel();
  const std::string plain = glb_bytes(model);
  EXPECT_LT(small().size(), 0.6 * static_cast<double>(plain.size()));
  const auto before = parse_glb(plain, "plain"), after = parse_glb(small(), "small");
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].name, after[i].name);
    EXPECT_EQ(places(before[i].surface), places(after[i].surface));
    const SurfaceReport told = inspect(before[i].surface), found = inspect(after[i].surface);
    EXPECT_TRUE(found.closed_oriented_manifold());
    ASSERT_EQ(told.shells.size(), found.shells.size());
    EXPECT_EQ(told.shells[0].genus, found.shells[0].genus);
    EXPECT_EQ(told.shells[0].kind, found.shells[0].kind);
    EXPECT_NEAR(told.shells[0].volume, found.shells[0].volume, 1e-9 * std::abs(told.shells[0].volume));
  }
}

TEST(CompressedGlb, SaysWhatItNeedsAndKeepsTheRest) {
  const json before = document_of(glb_bytes(models::tooth_and_enamel())), after = document_of(small());
  EXPECT_EQ(after["extensionsRequired"], json::array({"EXT_meshopt_compression"}));
  EXPECT_EQ(after["extensionsUsed"], after["extensionsRequired"]);
  for (const char* key : {"asset", "nodes", "meshes", "materials", "accessors", "scenes"})
    EXPECT_EQ(before[key], after[key]) << key;
  EXPECT_EQ(after["buffers"][1]["byteLength"], before["buffers"][0]["byteLength"]);
  EXPECT_EQ(after["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"], true);
  for (std::size_t i = 0; i < before["bufferViews"].size(); ++i)
    EXPECT_EQ(after["bufferViews"][i]["byteLength"], before["bufferViews"][i]["byteLength"]);
}

TEST(CompressedGlb, IsTheSameEachTime) {
  EXPECT_EQ(small(), small());
  const std::string text = gltf_text(models::tooth_and_enamel(), {.compressed = true});
  EXPECT_EQ(text, gltf_text(models::tooth_and_enamel(), {.compressed = true}));
  EXPECT_EQ(json::parse(text)["bufferViews"], document_of(small())["bufferViews"]);
  EXPECT_NO_THROW(document_of(glb_bytes({}, {.compressed = true})));
}

TEST(CompressedGlb, LiesAreRefused) {
  using Change = std::function<void(json&, json&)>;
  const auto said = [](const char* key, json value) -> Change {
    return [=](json&, json& compression) { compression[key] = value; };
  };
  const char *positions = "POSITION", *corners = "indices";
  EXPECT_EQ(cause_with(positions, said("mode", "ATTRIBUTES")), "accepted");
  EXPECT_EQ(cause_with(positions, said("mode", "NUMBERS")), "unparsable");
  EXPECT_EQ(cause_with(positions, said("mode", 7)), "unparsable");
  EXPECT_EQ(cause_with(positions, said("mode", "INDICES")), "unparsable");  // a stride of twelve
  EXPECT_EQ(cause_with(positions, said("filter", "OCTAHEDRAL")), "unsupported");
  EXPECT_EQ(cause_with(positions, said("byteStride", 0)), "unparsable");
  EXPECT_EQ(cause_with(positions, said("byteStride", 10)), "unparsable");
  EXPECT_EQ(cause_with(positions, said("byteStride", 260)), "unparsable");
  EXPECT_EQ(cause_with(positions, said("byteStride", 16)), "damaged-buffer");
  EXPECT_EQ(cause_with(positions, said("count", 1)), "damaged-buffer");
  EXPECT_EQ(cause_with(positions, said("count", 9007199254740991)), "truncated");
  EXPECT_EQ(cause_with(positions, said("count", -1)), "unparsable");
  EXPECT_EQ(cause_with(positions, said("byteLength", 40)), "truncated");
  EXPECT_EQ(cause_with(positions, said("byteLength", 9007199254740991)), "truncated");
  EXPECT_EQ(cause_with(positions, said("byteOffset", 9007199254740991)), "truncated");
  EXPECT_EQ(cause_with(positions, said("byteOffset", 1)), "damaged-buffer");
  EXPECT_EQ(cause_with(positions, said("buffer", 1)), "unsupported");
  EXPECT_EQ(cause_with(positions, said("buffer", 2)), "index-out-of-range");
  EXPECT_EQ(cause_with(corners, said("mode", "INDICES")), "damaged-buffer");
  EXPECT_EQ(cause_with(corners, said("mode", "ATTRIBUTES")), "damaged-buffer");
  EXPECT_EQ(cause_with(corners, said("count", 4)), "not-triangles");
  EXPECT_EQ(cause_with(corners, said("count", 3)), "damaged-buffer");
  EXPECT_EQ(cause_with(corners, said("byteStride", 8)), "unparsable");
  EXPECT_EQ(cause_with(corners, said("byteStride", 2)), "truncated");  // the accessor still wants four bytes
  EXPECT_EQ(cause_with(corners, said("filter", "EXPONENTIAL")), "unsupported");
  EXPECT_EQ(cause_with(corners, [](json&, json& compression) { compression = 5; }), "unparsable");
}

TEST(CompressedGlb, NoDamageDoesHarm) {
  Reconstruction model;
  model.solids.push_back(models::solid("tooth", shapes::sphere(2, 1)));
  const std::string whole = glb_bytes(model, {.compressed = true});
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_NE(cause_of(whole.substr(0, n)), "accepted") << n;
  std::mt19937 random(7);
  std::size_t refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = whole;
    const std::size_t binary = whole.size() / 2;  // behind the JSON part are the numbers: half of the changes go there
    bytes[i % 2 == 0 ? random() % whole.size() : binary + random() % (whole.size() - binary)] =
        static_cast<char>(random());
    refused += cause_of(bytes) != "accepted";
  }
  EXPECT_GT(refused, 100u);
}

}  // namespace
}  // namespace odontoscope
