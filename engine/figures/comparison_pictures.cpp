#include "engine/figures/comparison_pictures.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "engine/picture/png.h"
#include "engine/render/see_through.h"
#include "engine/view/offscreen.h"

namespace odontoscope::figures {
namespace {

constexpr PixelSize size{420, 560};
constexpr double aspect = static_cast<double>(size.width) / size.height;

std::vector<NamedSurface> surfaces_of(const ComparedMethod& method) {
  std::vector<NamedSurface> surfaces;
  for (const ComparedSurface& one : method.surfaces) surfaces.push_back({one.structure, one.surface});
  return surfaces;
}

/// How far the outline of DB may lie from that of DT: a cell's diagonal, and the layer that closes its ends.
double rim_of(const Grid& grid) {
  double tallest = 0;
  for (std::size_t k = 1; k < grid.layers.size(); ++k)
    tallest = std::max(tallest, grid.layers[k].z - grid.layers[k - 1].z);
  return std::hypot(grid.dx, grid.dy) + tallest;
}

struct Shot {
  const char* caption;
  BackFaces back_faces;
  bool edges;
};
constexpr Shot shots[] = {
    {"back faces left out, as games and web viewers draw", BackFaces::cull, false},
    {"both sides drawn", BackFaces::show, false},
    {"faulty edges: cracks blue, misoriented orange, non-manifold yellow", BackFaces::show, true}};

void draw(ComparedMethod& method, const Model& model, Scene scene, Renderer& renderer, const Gl& gl) {
  const GpuModel gpu_model = upload(gl, model);
  OverlaySource source;
  source.faulty_edges = faulty_edges(surfaces_of(method), model);
  for (const Shot& shot : shots) {
    scene.back_faces = shot.back_faces;
    scene.overlays.edges = shot.edges;
    const GpuOverlay overlay = upload(gl, make_overlay(source, scene.overlays, model));
    const char* caption = shot.edges && source.faulty_edges.empty() ? "faulty edges: none" : shot.caption;
    std::string bytes = png_bytes(picture_of(gl, renderer, gpu_model, model, scene, {size, {}}, &overlay));
    method.pictures.push_back({{bytes.begin(), bytes.end()}, caption});
  }
}

}  // namespace

void add_pictures(Comparison& comparison, const Gl& gl, const Progress& progress) {
  const ShaderLibrary shaders = shaders_from_environment();
  Renderer renderer(gl, shaders);
  std::vector<Model> models;
  for (const ComparedMethod& method : comparison.methods) models.push_back(make_model(surfaces_of(method)));
  Scene scene = usual_scene(models.front(), aspect);
  for (Look& look : scene.looks) look.opacity = 1;
  for (std::size_t i = 0; i < models.size(); ++i) {
    progress.check();
    progress.tell("pictures", 0.5 * static_cast<double>(i) / static_cast<double>(models.size()));
    draw(comparison.methods[i], models[i], scene, renderer, gl);
  }
  progress.check();
  const std::vector<SeeThrough> seen =
      see_through(gl, shaders, models.front(), models, {.rim_mm = rim_of(comparison.grid)});
  for (std::size_t i = 0; i < seen.size(); ++i)
    comparison.methods[i].seen_through =
        SeenThrough{seen[i].cameras, seen[i].culled_share(), seen[i].two_sided_share()};
}

}  // namespace odontoscope::figures
