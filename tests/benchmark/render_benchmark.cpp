// How fast are pictures? One run on EGL, 1280 x 720, one sample a pixel; every figure that is compared is taken in
// turns with the other.
//
//   odontoscope_render_benchmark [FOLDER [F3D WORD...]]
//
// FOLDER: molar.glb is written there and drawn by the program, and by f3d if the words that start it follow, e.g.
// "xvfb-run -a f3d". The bars are those of docs/testing.md.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "engine/view/offscreen.h"
#include "tests/benchmark/bare_program.h"
#include "tests/benchmark/first_picture.h"
#include "tests/render/shapes.h"

namespace odontoscope {
namespace {

using testing_support::ball;

constexpr PixelSize size{1280, 720};
constexpr double most_over_bare = 1.5, most_upload_ms = 8, most_of_f3d = 0.5;

/// By the wall clock, and of all processors together.
struct Milliseconds {
  double wall = 0, processor = 0;
};

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

Milliseconds milliseconds(const Gl& gl, const std::function<void()>& work) {
  const double processor = processor_seconds();
  const auto start = std::chrono::steady_clock::now();
  work();
  gl.Finish();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {1000 * wall.count(), 1000 * (processor_seconds() - processor)};
}

/// The median of each.
Milliseconds middle(std::vector<Milliseconds> times) {
  const auto at = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  Milliseconds result;
  std::nth_element(times.begin(), at, times.end(), [](const auto& a, const auto& b) { return a.wall < b.wall; });
  result.wall = at->wall;
  std::nth_element(times.begin(), at, times.end(),
                   [](const auto& a, const auto& b) { return a.processor < b.processor; });
  result.processor = at->processor;
  return result;
}

/// A ball with bumps like cusps: 4 rings^2 triangles.
Model bumpy_ball(int rings) {
  SurfaceMesh mesh = ball({{}, 5, rings});
  for (Point3& p : mesh.points) {
    const double bump = 1 + 0.08 * std::sin(1.7 * p.x) * std::sin(1.3 * p.y) * std::cos(1.1 * p.z);
    p = {bump * p.x, bump * p.y, 1.5 * bump * p.z};
  }
  return make_model({{"tooth", mesh}});
}

std::size_t triangles_in(const Model& model) {
  std::size_t sum = 0;
  for (const ModelPart& part : model.parts) sum += part.indices.size() / 3;
  return sum;
}

class FrameTimes {
 public:
  FrameTimes(const Gl& gl, Renderer& renderer)
      : gl_(gl), renderer_(renderer), bare_(gl, size), pixels_(gl, {size, {GL_RGBA8}, GL_DEPTH_COMPONENT32F}) {}

  /// True if the bar is met.
  bool measure(int rings, bool judged) {
    const Model model = bumpy_ball(rings);
    const GpuModel gpu_model = upload(gl_, model);
    bool met = true;
    for (const bool culled : {true, false})
      for (const bool occlusion : {false, true}) {
        Scene scene = usual_scene(model, double(size.width) / size.height);
        scene.back_faces = culled ? BackFaces::cull : BackFaces::show;
        scene.occlusion.on = occlusion;
        const auto [ours, bare] = in_turns(gpu_model, model, scene, culled);
        std::printf("%7zu triangles, %-11s %-20s ours %6.1f ms, bare program %6.1f ms: %5.2f (processor time %5.2f)\n",
                    triangles_in(model), culled ? "culled," : "not culled,",
                    occlusion ? "ambient occlusion" : "no ambient occlusion", ours.wall, bare.wall,
                    ours.wall / bare.wall, ours.processor / bare.processor);
        if (judged && culled && !occlusion) met = ours.wall <= most_over_bare * bare.wall;
      }
    return met;
  }

 private:
  std::pair<Milliseconds, Milliseconds> in_turns(const GpuModel& gpu_model, const Model& model, const Scene& scene,
                                                 bool culled) {
    const View view = view_of(scene.camera, model, double(size.width) / size.height);
    const Pane pane{view, {pixels_.id(), 0, 0, size, true}};
    std::vector<Milliseconds> ours, bare;
    for (int i = 0; i < 25; ++i) {
      ours.push_back(milliseconds(gl_, [&] { renderer_.draw(gpu_model, scene, {&pane, 1}, {1}); }));
      bare.push_back(milliseconds(gl_, [&] { bare_.draw(gpu_model, view, culled); }));
    }
    return {middle(ours), middle(bare)};
  }

  const Gl& gl_;
  Renderer& renderer_;
  BareProgram bare_;
  Framebuffer pixels_;
};

bool measure_upload(const Gl& gl) {
  const Model model = bumpy_ball(158);
  std::vector<Milliseconds> times;
  for (int i = 0; i < 25; ++i) times.push_back(milliseconds(gl, [&] { const GpuModel uploaded = upload(gl, model); }));
  const double took = middle(times).wall;
  std::printf("upload of %zu triangles: %.2f ms; bar %.0f ms\n", triangles_in(model), took, most_upload_ms);
  return took <= most_upload_ms;
}

bool measure_first_picture(const std::string& folder, std::vector<std::string> f3d) {
  const std::string mesh = folder + "/molar.glb", picture = folder + "/first.png";
  const std::string stack = folder + "/molar.json";
  if (!seconds_to_run({ODONTOSCOPE_PROGRAM, "-q", "sample", "molar", "-o", stack}, 1) ||
      !seconds_to_run({ODONTOSCOPE_PROGRAM, "-q", "reconstruct", stack, "-o", mesh}, 1)) {
    std::printf("could not make %s\n", mesh.c_str());
    return false;
  }
  const std::vector<std::string> words = {ODONTOSCOPE_PROGRAM, "-q",        "render", mesh, "-o", picture, "--size",
                                          "1280x720",          "--samples", "1"};
  std::vector<std::string> as_usual = words;
  as_usual.back() = "4";
  const auto ours = seconds_to_run(words, 9), usual = seconds_to_run(as_usual, 9);
  if (!ours || !usual) return false;
  std::printf("start to first picture: %.3f s (1 sample a pixel), %.3f s (4, the default)\n", *ours, *usual);
  if (f3d.empty()) return true;
  f3d.insert(f3d.end(), {mesh, "--output=" + folder + "/f3d.png", "--resolution=1280,720"});
  const auto theirs = seconds_to_run(f3d, 9);
  if (!theirs) {
    std::printf("f3d could not be run\n");
    return false;
  }
  std::printf("f3d: %.3f s; ours take %.2f and %.2f of that; bar %.1f\n", *theirs, *ours / *theirs, *usual / *theirs,
              most_of_f3d);
  return *ours <= most_of_f3d * *theirs;
}

int benchmark(const std::vector<std::string>& words) {
  const std::unique_ptr<GlContext> context = make_context({.backend = Backend::egl});
  std::printf("%s\n", context->in_words().c_str());
  const Gl& gl = context->gl();
  std::unique_ptr<Renderer> renderer;
  std::printf("all programs compiled in %.1f ms\n",
              milliseconds(gl, [&] { renderer = std::make_unique<Renderer>(gl, shaders_from_environment()); }).wall);
  FrameTimes frames(gl, *renderer);
  frames.measure(45, false);
  bool met = frames.measure(154, true);
  frames.measure(500, false);
  met = measure_upload(gl) && met;
  if (!words.empty()) met = measure_first_picture(words.front(), {words.begin() + 1, words.end()}) && met;
  std::printf(met ? "All bars are met.\n" : "Not all bars are met.\n");
  return met ? 0 : 1;
}

}  // namespace
}  // namespace odontoscope

int main(int argc, char** argv) { return odontoscope::benchmark({argv + 1, argv + argc}); }
