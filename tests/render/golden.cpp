#include "tests/render/golden.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/scene/scene_json.h"
#include "tests/output/temporary_folder.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

constexpr PixelSize size{200, 150};

/// The embedded shaders with some text changed. Every edit must find what it changes.
void write_edited_shaders(const std::vector<Mutation::Edit>& edits, const std::filesystem::path& folder) {
  for (const EmbeddedFile& shader : embedded_shaders()) {
    std::string text(shader.bytes);
    for (const Mutation::Edit& edit : edits) {
      if (edit.shader != shader.name) continue;
      const std::size_t at = text.find(edit.from);
      ASSERT_NE(at, std::string::npos) << edit.from;
      text.replace(at, edit.from.size(), edit.to);
    }
    std::ofstream(folder / std::string(shader.name)) << text;
  }
}

}  // namespace

const std::vector<GoldenCase>& golden_cases() {
  static const std::vector<GoldenCase> cases = {
      {"molar-translucent", small_molar_surfaces},
      {"molar-section", small_molar_surfaces},
      {"molar-occlusal", small_molar_surfaces},
      {"molar-wire", small_molar_surfaces},
      {"molar-contours", small_molar_surfaces, small_molar_overlays},
      {"molar-slab", small_molar_surfaces, small_molar_overlays},
      {"ring-faulty-edges",
       [] {
         return std::vector<NamedSurface>{{"ring", faulty_ring()}};
       }},
      {"ring-faulty-edges-hidden",
       [] {
         return std::vector<NamedSurface>{{"ring", faulty_ring()}};
       }},
      {"coarse-ball",
       [] {
         return std::vector<NamedSurface>{{"ball", coarse_ball(5)}};
       }},
      {"ring-inside-out",
       [] {
         return std::vector<NamedSurface>{{"ring", reversed(ring({}))}, {"ball", coarse_ball(2)}};
       }},
      {"tinted",
       [] {
         return std::vector<NamedSurface>{{"ring", reversed(ring({}))}, {"ball", coarse_ball(2)}};
       }},
      {"hollow-ball-section",
       [] {
         return std::vector<NamedSurface>{{"shell", ball({{}, 5}), "shell"},
                                          {"shell cavity", reversed(ball({{}, 2})), "shell", true}};
       }},
  };
  return cases;
}

std::string golden_file(const GoldenCase& golden, const char* ending) {
  return std::string(ODONTOSCOPE_GOLDENS) + "/" + golden.name + ending;
}

Image draw_golden(GlContext& context, const GoldenCase& golden, const Mutation& mutation) {
  std::vector<NamedSurface> surfaces = golden.surfaces();
  const double aspect = static_cast<double>(size.width) / size.height;
  // The scene is that of the sound model, so that a mutant is drawn from where the golden was.
  Scene scene = read_scene(golden_file(golden, ".json"), usual_scene(make_model(surfaces), aspect));
  if (mutation.surfaces) mutation.surfaces(surfaces, scene);
  if (mutation.scene) mutation.scene(scene);
  Model model = make_model(surfaces);
  if (mutation.model) mutation.model(model);
  const TemporaryFolder folder;
  ShaderLibrary shaders;
  if (!mutation.shaders.empty()) {
    write_edited_shaders(mutation.shaders, folder.path());
    shaders.folder = folder.path();
  }
  context.make_current();
  Renderer renderer(context.gl(), shaders);
  const GpuModel gpu_model = upload(context.gl(), model);
  OverlaySource source = golden.overlays ? golden.overlays() : OverlaySource{};
  source.faulty_edges = faulty_edges(surfaces, model);
  const GpuOverlay overlay = upload(context.gl(), make_overlay(source, scene.overlays, model));
  return picture_of(context.gl(), renderer, gpu_model, model, scene, {size, {2}}, &overlay);
}

}  // namespace odontoscope::testing_support
