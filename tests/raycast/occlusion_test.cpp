// Volume, surfaces clear and solid, and the section's cap in one picture, against casting all of them together on the
// processor.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/output/temporary_folder.h"
#include "tests/radiograph/solids.h"
#include "tests/raycast/cast_bench.h"

namespace odontoscope::test {
namespace {

/// A solid ball in the volume, and a clear box around it; or where the cut leaves it whole, since its cap would be
/// solid.
struct Stage {
  explicit Stage(bool is_cut)
      : clear(is_cut ? block({-4.2, -3.7, 2}, {-1.2, -1.1, 4.4}) : block({-3.7, -2.9, -3.3}, {2.8, 2.2, 4.1})) {}

  SurfaceMesh solid = ball({0.9, 0.3, -0.9}, 1.7, 24, 16), clear;
  ValueGrid grid = whole(lumps());
  Model model = make_model({{"clear", clear}, {"solid", solid}});
};

class Occlusion : public CastTest, public ::testing::WithParamInterface<NamedCamera> {
 protected:
  static constexpr PixelSize picture{60, 60};

  Scene scene(const Stage& stage, const std::optional<Section>& section, VolumeLook::Shows shows) {
    VolumeLook look = shaded_look();
    for (TransferPoint& point : look.transfer) point.extinction *= 3;
    look.shows = shows;
    Scene scene = scene_of(stage.model, GetParam().camera, look);
    scene.section = section;
    scene.cap.shows = CapLook::Shows::plain;
    *scene.look_of("clear") = {"clear", colour_of(0x4060a0), 0.4f};
    *scene.look_of("solid") = {"solid", colour_of(0x905030), 1};
    return scene;
  }

  /// Without gloss, which may be brighter than a screen shows and so could not be read back.
  static ShaderEdit dull() { return {"lighting.glsl", "return 0.25 * n_l", "return 0.0 * n_l"}; }

  /// A structure alone, without the volume, on nothing: what it looks like where it is seen.
  Image alone(const Stage& stage, Scene scene, const char* structure, const ShaderLibrary& shaders) {
    scene.volume.shows = VolumeLook::Shows::surfaces;
    scene.background.kind = Background::Kind::transparent;
    for (Look& look : scene.looks) look.visible = look.structure == structure;
    return cast(stage.model, stage.grid, scene, shaders, picture);
  }

  static Seen seen(const Image& image, int x, int y) {
    const auto pixel = image.pixel(x, y);
    const double covered = pixel[3] / 255.0;
    return {covered * glm::dvec3(decoded(pixel[0]), decoded(pixel[1]), decoded(pixel[2])), covered};
  }

  /// How far the cap of the solid lies away, where the eye sees it.
  static std::optional<double> cap(const Stage& stage, const Ray& ray, const std::optional<Section>& section) {
    if (!section) return std::nullopt;
    const double speed = glm::dot(section->normal, ray.direction),
                 way = glm::dot(section->normal, section->point_mm - ray.origin) / speed;
    if (!(speed < 0) || way < ray.begin) return std::nullopt;
    Ray onward{ray.at(way), ray.direction, 0};
    SurfaceMesh inside_out = turned_inside_out(stage.solid);
    const auto out = hit(inside_out, onward, std::nullopt), in = hit(stage.solid, onward, std::nullopt);
    return out && (!in || *out < *in) ? std::optional(way) : std::nullopt;
  }

  struct Judged {
    double worst = 0;
    int disagreeing = 0, behind_both = 0, capped = 0;  // pixels: with other surfaces than foretold; ...
  };

  Judged judged(const std::optional<Section>& section, const std::vector<ShaderEdit>& edits = {}) {
    const testing_support::TemporaryFolder as_they_are, edited;
    std::vector<ShaderEdit> all_edits{dull()};
    write_edited_shaders(all_edits, as_they_are.path().string());
    all_edits.insert(all_edits.end(), edits.begin(), edits.end());
    write_edited_shaders(all_edits, edited.path().string());
    const ShaderLibrary sound{as_they_are.path()};
    const Stage stage(section.has_value());
    const Scene both = scene(stage, section, VolumeLook::Shows::both);
    const Image drawn = cast(stage.model, stage.grid, both, {edited.path()}, picture),
                solid_alone = alone(stage, both, "solid", sound), clear_alone = alone(stage, both, "clear", sound);
    Judged judged;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const Ray ray = ray_through(both.camera, picture, x, y);
        const Span span = span_of(ray, stage.grid, section);
        std::optional<double> clear = hit(stage.clear, ray, section), solid = hit(stage.solid, ray, section);
        if (const auto capped = cap(stage, ray, section); capped && (!solid || *capped < *solid)) {
          solid = capped;
          ++judged.capped;
        }
        if (clear.has_value() != (clear_alone.pixel(x, y)[3] > 0) ||
            solid.has_value() != (solid_alone.pixel(x, y)[3] > 0)) {
          ++judged.disagreeing;
          continue;
        }
        const double beyond = 1e9, far = solid.value_or(beyond), between = std::min(clear.value_or(far), far);
        judged.behind_both += clear && solid && between < far ? 1 : 0;
        const auto volume = [&](double from, double to) {
          return shaded(stage.grid, both.volume, ray, span, from, to);
        };
        Seen all = volume(ray.begin, between);
        if (between < far) all = over(all, over(seen(clear_alone, x, y), volume(between, far)));
        if (solid) all = over(all, seen(solid_alone, x, y));
        for (int channel = 0; channel < 3; ++channel)
          judged.worst = std::max(judged.worst, std::abs(encoded(all.light[channel]) -
                                                         drawn.pixel(x, y)[static_cast<std::size_t>(channel)]));
      }
    return judged;
  }
};

const Section cut{{0.5, 0.6, -0.4}, {-0.2, 0.9, -0.2}};
const Section cut_away_from_the_eye{{0.5, -0.6, -0.4}, {0.2, -0.9, 0.2}};

/// Half a level for eight bits of the picture, and as much again for those of the two that it is foretold from.
constexpr double two_roundings = 1.5;
/// Pixels whose middle lies so near an edge that single precision puts it on the other side.
constexpr int on_an_edge = 2;

TEST_P(Occlusion, OfVolumeAndSurfacesIsThatOfCastingThem) {
  const Judged found = judged(std::nullopt);
  EXPECT_LE(found.disagreeing, on_an_edge);
  EXPECT_GT(found.behind_both, GetParam().camera.near_mm > 0 ? -1 : 100);  // within the box its outside is not seen
  EXPECT_LT(found.worst, two_roundings);
}

TEST_P(Occlusion, OfTheCapTooIsThatOfCastingThem) {
  for (Section section : {cut, cut_away_from_the_eye}) {
    section.normal = glm::normalize(section.normal);
    const Judged found = judged(section);
    EXPECT_LE(found.disagreeing, on_an_edge);
    if (section.normal.y > 0 && GetParam().camera.near_mm == 0) {
      EXPECT_GT(found.capped, 60);
    }
    EXPECT_LT(found.worst, two_roundings);
  }
}

TEST_P(Occlusion, OfTheVolumeAloneLeavesSurfacesOut) {
  const Stage stage(false);
  const Scene alone = scene(stage, std::nullopt, VolumeLook::Shows::volume);
  const Image drawn = cast(stage.model, stage.grid, alone, {}, picture);
  double worst = 0, brightest = 0, off_the_integral = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Ray ray = ray_through(alone.camera, picture, x, y);
      const Span span = span_of(ray, stage.grid, std::nullopt);
      constexpr double nearly_none = 12;  // steps of an integral in place of one
      const Seen seen = shaded(stage.grid, alone.volume, ray, span, ray.begin, 1e9),
                 integral = shaded(stage.grid, alone.volume, ray, span, ray.begin, 1e9, nearly_none);
      for (int channel = 0; channel < 3; ++channel) {
        const double shown = drawn.pixel(x, y)[static_cast<std::size_t>(channel)];
        worst = std::max(worst, std::abs(encoded(seen.light[channel]) - shown));
        off_the_integral = std::max(off_the_integral, std::abs(encoded(integral.light[channel]) - shown));
        brightest = std::max(brightest, encoded(seen.light[channel]));
      }
    }
  EXPECT_GT(brightest, 80);
  EXPECT_LT(worst, 1);
  EXPECT_LT(off_the_integral, 2);
}

TEST_P(Occlusion, HasMutantsThatAreNoticed) {
  if (GetParam().camera.near_mm > 0) return;  // the eye is within the box: of its layers nothing is seen
  Section section = cut;
  section.normal = glm::normalize(section.normal);
  const ShaderEdit edits[] = {
      {"volume.frag", "min(way_to(ray, texelFetch(depth_opaque, at, 0).r), way_to(ray, texelFetch(depth_to, at, 0).r))",
       "way_to(ray, texelFetch(depth_opaque, at, 0).r)"},
      {"volume.frag", "if (from_the_eye == 0) from = max(from, way_to(ray, texelFetch(depth_from, at, 0).r));", ""},
      {"volume.frag", "min(way_to(ray, texelFetch(depth_opaque, at, 0).r), way_to(ray, texelFetch(depth_to, at, 0).r))",
       "way_to(ray, texelFetch(depth_to, at, 0).r)"},
      {"volume.frag", "colours += part / mean.a * mean.rgb",
       "colours += part / max(here.here.a, 1e-6) * here.here.rgb"},
      {"volume.frag", "float part = left * swallowed(", "float part = min(1.0, left + 1.0) * swallowed("},
      {"volume.frag", "share_by_slope(place_at(ray, 0.5 * (near + far))) * (far - near)", "stride"},
      {"volume_ray.glsl", "clip(dot(section.xyz, origin), dot(section.xyz, direction), -endless, section.w, ray);", ""},
      {"volume_ray.glsl", " - ray.begin) / stride, 1e8)))", " - ray.begin) / stride, 1e8)) + 12.0)"},
      {"volume_ray.glsl", "return z / ray.eye_direction.z;", "return -z + 0.0002;"}};
  for (const ShaderEdit& edit : edits) {
    EXPECT_GT(judged(section, {edit}).worst, 2) << edit.from << " -> " << edit.to;
  }
}

INSTANTIATE_TEST_SUITE_P(From, Occlusion, ::testing::ValuesIn(cameras()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace odontoscope::test
