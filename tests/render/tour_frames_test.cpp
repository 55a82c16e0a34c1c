// What a film of a tour shows: wall and nothing else, from its right side, and from picture to picture a little more of
// it.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "engine/navigate/seen_within.h"
#include "engine/navigate/tour.h"
#include "engine/render/face_count.h"
#include "engine/scene/shells.h"
#include "recon/cavity/centre_lines.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/sample/sample_tooth.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"
#include "tests/render/drawing.h"

namespace odontoscope::testing_support {
namespace {

constexpr PixelSize size{96, 72};
constexpr double film_rate = 30;
/// Of 255, over all pixels and channels: between pictures a thirtieth of a second apart. 6.8 was measured at most,
/// where the eye turns fast near an apex.
constexpr double most_mean_change = 8;

struct Filmed {
  std::string skipped;  // why there is none
  Model model;
  VoidWall wall;
  std::vector<CentreLine> canals;
};

Filmed filmed_of(const ContourStack& stack) {
  std::vector<NamedSurface> surfaces;
  std::vector<StructureSurface> looked_at;
  const Reconstruction made = reconstruct(stack);
  for (const Solid& solid : made.solids) {
    add_shells(solid.structure, solid.surface, solid.report, surfaces);
    looked_at.push_back({solid.structure, &solid.surface});
  }
  const Cavity cavity = cavities_in(looked_at).at(0);
  return {{}, make_model(surfaces), {cavity.structure + " cavity", false}, centre_lines(cavity).canals};
}

const Filmed& filmed(const std::string& name) {
  static std::map<std::string, Filmed> known;
  if (known.contains(name)) return known.at(name);
  if (name == "Sample") return known[name] = filmed_of(sample_tooth(ToothKind::molar));
  const std::filesystem::path file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";
  if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file))
    return known[name] = Filmed{"the data set ct_molar is not here", {}, {}, {}};
  return known[name] = filmed_of(iso_contours(read_volume(file.string()), {{120, "tooth"}}, {.min_area = 4}).stack);
}

double mean_change(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    sum += std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
  return sum / (0.75 * static_cast<double>(a.rgba.size()));  // alpha never changes
}

/// In steady motion half of the time brings half of the change; where a film is cut, or the camera leaps, all of it
/// falls into one half.
bool leaps(const Image& before, const Image& between, const Image& after) {
  constexpr double most_of_it = 0.75, unseen = 0.25;
  return std::max(mean_change(before, between), mean_change(between, after)) >
         most_of_it * mean_change(before, after) + unseen;
}

class TourFrames : public DrawingTest, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    if (!filmed(GetParam()).skipped.empty()) GTEST_SKIP() << filmed(GetParam()).skipped;
    DrawingTest::SetUp();
    if (IsSkipped()) return;
    renderer_ = std::make_unique<Renderer>(gl(), shaders_from_environment());
    gpu_model_ = upload(gl(), subject().model);
  }
  void TearDown() override {
    gpu_model_ = {};
    renderer_.reset();
    DrawingTest::TearDown();
  }
  const Filmed& subject() const { return filmed(GetParam()); }

  /// As `render --tour` has it.
  Scene frame(const TourInstant& now) const {
    constexpr double lamp_reach = 5;
    Scene scene =
        seen_within(usual_scene(subject().model, 4.0 / 3), subject().model, subject().wall, lamp_reach * now.width);
    scene.camera = now.camera;
    scene.back_faces = BackFaces::cull;
    return scene;
  }
  Image picture(const Scene& scene) {
    return picture_of(gl(), *renderer_, gpu_model_, subject().model, scene, {.size = size, .render = {.side = 1}});
  }

  /// Pixels in which something else than the wall's front is seen: they change with the background's colour, or where
  /// back faces are drawn in alarm, but for ties of front and back at a fold. With all of the solid as many fronts as
  /// backs lie on each line of sight, which tells ties from holes (judge).
  int others(const Scene& scene) {
    const Image seen = picture(scene);
    Scene tinted = scene, before_green = scene, solid = scene;
    tinted.back_faces = BackFaces::tint;
    before_green.background = {Background::Kind::plain, {0, 1, 0}, {0, 1, 0}};
    for (const ModelPart& part : subject().model.parts)
      solid.look_of(part.structure)->visible = part.solid == solid_of_wall();
    const Image back_faces = picture(tinted), background = picture(before_green);
    const FaceCounts faces = FaceCounter(gl(), shaders_from_environment())
                                 .count(gpu_model_, solid, view_of(scene.camera, subject().model, 4.0 / 3), size);
    int others = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        others += seen.pixel(x, y) != background.pixel(x, y) ||
                  (seen.pixel(x, y) != back_faces.pixel(x, y) && !tie(faces, x, size.height - 1 - y));
    return others;
  }

 private:
  static bool tie(const FaceCounts& faces, int x, int y) {
    const auto at = static_cast<std::size_t>(y * size.width + x);
    return faces.back_depth[at] <= faces.front_depth[at] && !back_is_nearest(faces, x, y);
  }
  std::string solid_of_wall() const {
    for (const ModelPart& part : subject().model.parts)
      if (part.structure == subject().wall.structure) return part.solid;
    return {};
  }
  std::unique_ptr<Renderer> renderer_;
  GpuModel gpu_model_;
};

TEST_P(TourFrames, ShowTheWallAloneAndFlow) {
  ASSERT_EQ(subject().canals.size(), 3u);
  for (const CentreLine& canal : subject().canals) {
    const Tour tour(canal);
    for (const double share : {0.0, 0.05, 0.12, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0}) {
      const double seconds = share * (tour.seconds() - 1 / film_rate);
      const Scene now = frame(tour.at(seconds));
      EXPECT_EQ(others(now), 0) << canal.name << " at " << seconds << " s";
      const Image before = picture(now), between = picture(frame(tour.at(seconds + 0.5 / film_rate))),
                  after = picture(frame(tour.at(seconds + 1 / film_rate)));
      EXPECT_LT(mean_change(before, after), most_mean_change) << canal.name << " at " << seconds << " s";
      EXPECT_FALSE(leaps(before, between, after)) << canal.name << " at " << seconds << " s";
    }
  }
}

TEST_P(TourFrames, ALeapIsSeen) {
  const CentreLine& canal = subject().canals.front();
  const Tour tour(canal);
  // At the rim of the orifice, where there is something to be seen of a leap; deep in a canal all rings look alike.
  const double rim = canal.points.at(canal.orifice).along;
  double seconds = 0;
  while (tour.at(seconds + 0.75).along < rim) seconds += 0.5 / film_rate;
  const Image before = picture(frame(tour.at(seconds))), after = picture(frame(tour.at(seconds + 0.75)));
  EXPECT_GT(mean_change(before, after), most_mean_change) << "three quarters of a second in one step";
  TourInstant aside = tour.at(seconds);
  aside.camera.position += 0.1 * aside.width * aside.camera.up;
  aside.camera.target += 0.1 * aside.width * aside.camera.up;
  EXPECT_TRUE(leaps(before, before, picture(frame(aside)))) << "a tenth of the radius";
}

TEST_P(TourFrames, AnythingElseIsSeen) {
  const Tour tour(subject().canals.front());
  const TourInstant now = tour.at(0.3 * tour.seconds());
  ASSERT_EQ(others(frame(now)), 0);
  Scene inside_out = frame(now), beyond = frame(now);
  inside_out.look_of(subject().wall.structure)->as_body = true;
  beyond.camera.position += 4 * now.width * glm::dvec3(1, 0, 0);  // behind the wall
  beyond.camera.target += 4 * now.width * glm::dvec3(1, 0, 0);
  EXPECT_GT(others(inside_out), 1000);
  EXPECT_GT(others(beyond), 1000);
}

INSTANTIATE_TEST_SUITE_P(Molars, TourFrames, ::testing::Values("Sample", "CT"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace odontoscope::testing_support
