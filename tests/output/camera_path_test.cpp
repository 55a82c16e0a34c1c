// Cameras and animations in glTF: what a player makes of the numbers is the path that was given, and surfaces are read
// as if there were none.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "recon/formats/read_mesh.h"
#include "recon/formats/write_glb.h"
#include "tests/output/models.h"

namespace odontoscope {
namespace {

using nlohmann::json;

struct Glb {
  json document;
  std::string buffer;

  explicit Glb(const std::string& bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, 4);
    document = json::parse(bytes.substr(20, length));
    buffer = bytes.substr(28 + length);
  }
  std::vector<float> floats(std::size_t accessor) const {
    const json& described = document["accessors"][accessor];
    const json& view = document["bufferViews"][described["bufferView"].get<std::size_t>()];
    std::vector<float> values(view["byteLength"].get<std::size_t>() / sizeof(float));
    std::memcpy(values.data(), buffer.data() + view["byteOffset"].get<std::size_t>(), sizeof(float) * values.size());
    return values;
  }
};

/// Turns the vector as glTF defines rotations.
Direction turned(const float* q, const Direction& v) {
  const Direction axis{q[0], q[1], q[2]};
  const Direction t = 2 * cross(axis, v);
  return v + static_cast<double>(q[3]) * t + cross(axis, t);
}

/// Looks into every direction of a ball, up as it comes.
CameraPath round_look() {
  CameraPath path{.name = "canal 1", .field_of_view_deg = 80, .near_mm = 0.01, .far_mm = 30, .keys = {}};
  for (int i = 0; i < 200; ++i) {
    const double t = 0.1 * i, z = std::cos(0.37 * t), r = std::sqrt(1 - z * z);
    const Direction sight{r * std::cos(3 * t), r * std::sin(3 * t), z};
    const Direction side = cross(sight, std::abs(z) < 0.9 ? Direction{0, 0, 1} : Direction{1, 0, 0});
    path.keys.push_back({0.05 * i, {t, -2 * t, 3 + t}, sight, cross(1 / length(side) * side, sight)});
  }
  return path;
}

TEST(GlbCameraPath, PlaysAsGiven) {
  const CameraPath path = round_look();
  const Glb glb(glb_bytes(models::tooth_and_enamel(), {.paths = {path}}));
  const json& node = glb.document["nodes"].back();
  EXPECT_EQ(node["name"], "canal 1");
  EXPECT_EQ(glb.document["nodes"][0]["children"].back(), glb.document["nodes"].size() - 1);  // turned with the model
  const json& camera = glb.document["cameras"][node["camera"].get<std::size_t>()];
  EXPECT_EQ(camera["type"], "perspective");
  EXPECT_NEAR(camera["perspective"]["yfov"].get<double>(), 80 * std::numbers::pi / 180, 1e-9);
  EXPECT_NEAR(camera["perspective"]["znear"].get<double>(), 1e-5, 1e-12);
  EXPECT_NEAR(camera["perspective"]["zfar"].get<double>(), 0.03, 1e-9);
  EXPECT_FALSE(camera["perspective"].contains("aspectRatio")) << "that is the window's";

  const json& animation = glb.document["animations"].at(0);
  EXPECT_EQ(animation["name"], "canal 1");
  ASSERT_EQ(animation["channels"].size(), 2u);
  for (const json& channel : animation["channels"]) {
    EXPECT_EQ(channel["target"]["node"], glb.document["nodes"].size() - 1);
    const json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
    EXPECT_EQ(sampler.value("interpolation", "LINEAR"), "LINEAR");
    const std::vector<float> times = glb.floats(sampler["input"]), values = glb.floats(sampler["output"]);
    ASSERT_EQ(times.size(), path.keys.size());
    const bool moves = channel["target"]["path"] == "translation";
    ASSERT_EQ(values.size(), (moves ? 3 : 4) * times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      const CameraKey& key = path.keys[i];
      EXPECT_FLOAT_EQ(times[i], static_cast<float>(key.seconds));
      if (moves) {
        EXPECT_NEAR(length(Direction{1000 * values[3 * i], 1000 * values[3 * i + 1], 1000 * values[3 * i + 2]} +
                           -1 * Direction{key.at.x, key.at.y, key.at.z}),
                    0, 1e-5);
        continue;
      }
      const float* q = &values[4 * i];
      EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-6);
      EXPECT_NEAR(length(turned(q, {0, 0, -1}) + -1 * key.view_direction), 0, 1e-6) << i;
      EXPECT_NEAR(length(turned(q, {0, 1, 0}) + -1 * key.up), 0, 1e-6) << i;
      if (i == 0) continue;
      EXPECT_GT(q[0] * q[-4] + q[1] * q[-3] + q[2] * q[-2] + q[3] * q[-1], 0) << "the long way round at " << i;
    }
    const json& input = glb.document["accessors"][sampler["input"].get<std::size_t>()];
    EXPECT_EQ(input["min"][0], 0);
    EXPECT_FLOAT_EQ(input["max"][0].get<float>(), times.back());
  }
}

TEST(GlbCameraPath, ChangesNothingElse) {
  const Reconstruction model = models::tooth_and_enamel();
  const std::string plain = glb_bytes(model), with = glb_bytes(model, {.paths = {round_look(), round_look()}});
  const Glb before(plain), after(with);
  EXPECT_FALSE(before.document.contains("cameras"));
  EXPECT_FALSE(before.document.contains("animations"));
  EXPECT_EQ(after.document["animations"].size(), 2u);
  EXPECT_EQ(before.document["meshes"], after.document["meshes"]);
  EXPECT_EQ(after.buffer.substr(0, before.buffer.size()), before.buffer);
  const auto meshes = parse_glb(plain, "plain"), again = parse_glb(with, "with");
  ASSERT_EQ(meshes.size(), again.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    EXPECT_EQ(meshes[i].name, again[i].name);
    EXPECT_EQ(meshes[i].surface.points, again[i].surface.points);
    EXPECT_EQ(meshes[i].surface.triangles, again[i].surface.triangles);
  }
}

}  // namespace
}  // namespace odontoscope
