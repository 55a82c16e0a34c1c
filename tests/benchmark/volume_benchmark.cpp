// Casts rays through a volume as often as it is asked: for volume_against_vtk.py, which times another program in turns
// with it.
//
//   odontoscope_volume_benchmark FILE AIR DENTINE PICTURE.png
//
// For each line that comes in one picture is drawn, 1280 x 720 on EGL, lit, and its milliseconds go out: by the wall
// clock, and of all processors. The line "draw" asks for one ray a pixel; "still" for four samples a pixel, as many
// rays as they need; "full" for a ray through each of the four, and how far the still is off that: by how much of 255
// at worst, and in how many pixels by more than two. The first answer is the camera (position, target, up, angle), the
// length of a step in mm, and the transfer function.

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>

#include "engine/picture/png.h"
#include "engine/view/offscreen.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {
namespace {

constexpr PixelSize size{1280, 720};

double milliseconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

SurfaceMesh box_of(const ValueGrid& grid) {
  const glm::dvec3 low = grid.first_mm,
                   high = low + grid.step_mm * (glm::dvec3(grid.size[0], grid.size[1], grid.size[2]) - 1.0);
  SurfaceMesh mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.points.push_back({i & 1u ? high.x : low.x, i & 2u ? high.y : low.y, i & 4u ? high.z : low.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// By how much they differ at most, of 255, and in how many pixels by more than two.
std::pair<int, int> difference(const Image& one, const Image& other) {
  int most = 0, pixels = 0;
  for (std::size_t pixel = 0; pixel < one.rgba.size(); pixel += 4) {
    int here = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i) here = std::max(here, std::abs(one.rgba[i] - other.rgba[i]));
    most = std::max(most, here);
    pixels += here > 2;
  }
  return {most, pixels};
}

int benchmark(char** words) {
  const Volume volume = read_volume(words[1], {}, {});
  constexpr double all = 1e9;
  const ValueGrid grid = value_grid(volume, {glm::dvec3(-all), glm::dvec3(all)});
  const Model model = make_model({{"box", box_of(grid)}});
  Scene scene = usual_scene(model, static_cast<double>(size.width) / size.height);
  scene.background = {Background::Kind::plain, {0, 0, 0}, {0, 0, 0}};
  scene.volume.shows = VolumeLook::Shows::volume;
  scene.volume.transfer = transfer_of(TransferPreset::tooth, std::atof(words[2]), std::atof(words[3]));
  const std::unique_ptr<GlContext> context = make_context({.backend = Backend::egl});
  const Gl& gl = context->gl();
  Renderer renderer(gl, shaders_from_environment());
  const GpuModel gpu_model = upload(gl, model);
  const GpuValueGrid values = upload(gl, grid, gpu_model);
  GpuVolume gpu_volume(gl, grid, values.field());
  const Framebuffer pixels(gl, {size, {GL_RGBA8}, GL_DEPTH_COMPONENT32F});
  const Pane pane{view_of(scene.camera, model, static_cast<double>(size.width) / size.height),
                  {pixels.id(), 0, 0, size, true}};
  const PictureOptions picture{.size = size, .render = {.side = 1}};
  std::ofstream(words[4], std::ios::binary)
      << png_bytes(picture_of(gl, renderer, gpu_model, model, scene, picture, nullptr, &values, &gpu_volume));
  const Camera& camera = scene.camera;
  std::printf("[[%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g],%.9g,%.9g,[", camera.position.x, camera.position.y,
              camera.position.z, camera.target.x, camera.target.y, camera.target.z, camera.up.x, camera.up.y,
              camera.up.z, camera.field_of_view_deg, 1000 * static_cast<double>(gpu_volume.stride()));
  for (std::size_t i = 0; i < scene.volume.transfer.size(); ++i) {
    const TransferPoint& point = scene.volume.transfer[i];
    std::printf("%s[%.9g,%.9g,%.9g,%.9g,%.9g]", i > 0 ? "," : "", point.value, static_cast<double>(point.colour.red),
                static_cast<double>(point.colour.green), static_cast<double>(point.colour.blue), point.extinction);
  }
  std::printf("]]\n");
  std::fflush(stdout);
  Image still;
  for (std::string line; std::getline(std::cin, line);) {
    const RenderOptions options{.side = line == "draw" ? 1 : 2,
                                .rays = line == "still" ? RenderOptions::Rays::as_usual : RenderOptions::Rays::every};
    const double wall = milliseconds_of(CLOCK_MONOTONIC), processor = milliseconds_of(CLOCK_PROCESS_CPUTIME_ID);
    renderer.draw(gpu_model, scene, {&pane, 1}, options, nullptr, &values, &gpu_volume);
    gl.Finish();
    std::printf("%.3f %.3f", milliseconds_of(CLOCK_MONOTONIC) - wall,
                milliseconds_of(CLOCK_PROCESS_CPUTIME_ID) - processor);
    if (line == "still") still = read_pixels(gl, pixels.id(), size);
    if (std::getenv("DUMP"))
      std::ofstream(std::string(std::getenv("DUMP")) + line + ".png", std::ios::binary)
          << png_bytes(read_pixels(gl, pixels.id(), size));
    if (line == "full" && !still.rgba.empty()) {
      const auto [most, unlike] = difference(still, read_pixels(gl, pixels.id(), size));
      std::printf(" %d %d", most, unlike);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace odontoscope

int main(int count, char** words) {
  if (count != 5) {
    std::fprintf(stderr, "usage: %s FILE AIR DENTINE PICTURE.png\n", words[0]);
    return 2;
  }
  return odontoscope::benchmark(words);
}
