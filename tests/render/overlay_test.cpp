// Lines and tetrahedra over the picture.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "recon/mesh/surface_report.h"
#include "recon/mesh/tetra_report.h"
#include "tests/render/drawing.h"
#include "tests/render/shapes.h"

namespace odontoscope::testing_support {
namespace {

std::size_t lines_in(const std::vector<LineSet>& sets, LineKind kind) {
  std::size_t lines = 0;
  for (const LineSet& set : sets)
    if (set.kind == kind) lines += set.points.size() / 2;
  return lines;
}

TEST(Overlay, FaultyEdgesAreThoseThatTheReportCounts) {
  const std::vector<NamedSurface> surfaces = {{"ring", faulty_ring()}};
  const std::vector<LineSet> edges = faulty_edges(surfaces, make_model(surfaces));
  const SurfaceReport report = inspect(surfaces[0].surface);
  EXPECT_EQ(report.boundary_edges, 5u);
  EXPECT_EQ(report.misoriented_edges, 3u);
  EXPECT_EQ(report.nonmanifold_edges, 1u);
  EXPECT_EQ(lines_in(edges, LineKind::boundary_edge), report.boundary_edges);
  EXPECT_EQ(lines_in(edges, LineKind::misoriented_edge), report.misoriented_edges);
  EXPECT_EQ(lines_in(edges, LineKind::non_manifold_edge), report.nonmanifold_edges);
}

TEST(Overlay, ASoundModelHasNoFaultyEdges) { EXPECT_TRUE(faulty_edges(small_molar_surfaces(), small_molar()).empty()); }

TEST(Overlay, ContoursAreTheSlicesOrTheSlabsTwo) {
  const OverlaySource& source = small_molar_overlays();
  std::size_t points = 0;
  for (const Slice& slice : source.contours.slices)
    for (const Contour& contour : slice.contours) points += contour.points.size();
  EXPECT_EQ(lines_in(make_overlay(source, OverlayChoice{.contours = true, .slab = {}}, small_molar()).lines,
                     LineKind::contour),
            points);
  points = 0;
  for (const std::size_t k : {10u, 11u})
    for (const Contour& contour : source.contours.slices[k].contours) points += contour.points.size();
  EXPECT_EQ(lines_in(make_overlay(source, {.contours = true, .slab = 10}, small_molar()).lines, LineKind::contour),
            points);
}

SurfaceMesh mesh_of(const ModelPart& part) {
  SurfaceMesh soup;
  for (const std::uint32_t index : part.indices) {
    const glm::vec3& p = part.positions[index];
    soup.points.push_back({p.x / metres_per_mm, p.y / metres_per_mm, p.z / metres_per_mm});
  }
  for (PointIndex i = 0; i < soup.points.size(); i += 3) soup.triangles.push_back({i, i + 1, i + 2});
  return weld(soup);
}

TEST(Overlay, AllSlabsTogetherAreTheSolid) {
  const OverlaySource& source = small_molar_overlays();
  for (const OverlaySource::Solid& solid : source.solids) {
    double volume = 0;
    std::size_t tetrahedra = 0;
    for (std::size_t slab = 0; slab < source.slabs(); ++slab)
      for (const SlabPart& part : make_overlay(source, {.slab = slab, .shrink = 1}, small_molar()).slab) {
        if (part.surface.structure != solid.structure) continue;
        tetrahedra += part.tetrahedra;
        for (const Shell& shell : inspect(mesh_of(part.surface)).shells) volume += shell.volume;
      }
    EXPECT_EQ(tetrahedra, solid.tetrahedra.tetrahedra.size());
    EXPECT_NEAR(volume, inspect(solid.tetrahedra).volume, 1e-4 * volume) << solid.structure;
  }
}

TEST(Overlay, ShrunkTetrahedraAreClosedAndApart) {
  const OverlaySource& source = small_molar_overlays();
  const Overlay overlay = make_overlay(source, {.slab = 27, .shrink = 0.7f}, small_molar());
  ASSERT_FALSE(overlay.slab.empty());
  for (const SlabPart& part : overlay.slab) {
    ASSERT_EQ(part.surface.indices.size(), 12 * part.tetrahedra);
    const SurfaceReport report = inspect(mesh_of(part.surface));
    EXPECT_EQ(report.boundary_edges + report.nonmanifold_edges + report.misoriented_edges, 0u);
    EXPECT_EQ(report.shells.size(), part.tetrahedra);
    for (const Shell& shell : report.shells) EXPECT_EQ(shell.kind, Shell::Kind::external);
  }
}

TEST(Overlay, ASlabBeyondTheLastIsEmpty) {
  EXPECT_TRUE(make_overlay(small_molar_overlays(), {.slab = 100'000}, small_molar()).slab.empty());
  EXPECT_TRUE(make_overlay({}, {.contours = true, .edges = true, .slab = 0}, small_molar()).lines.empty());
}

class Lines : public DrawingTest {
 protected:
  /// One line at `y_mm` from the middle of a ball of radius 5, from x = -3 to 3; 5.03 is above its buccal side and
  /// still before the near plane.
  Image with_line(double y_mm, LineKind kind, PixelSize size = {160, 120}, double height_mm = 12) {
    const Model model = make_model({{"ball", ball({{}, 5})}});
    const auto at = [&](double x) { return glm::vec3(metres_per_mm * (glm::dvec3(x, y_mm, 0) - model.origin_mm)); };
    Overlay overlay;
    overlay.lines.push_back({kind, "", {at(-3), at(3)}});
    context().make_current();
    Renderer renderer(gl(), ShaderLibrary{});
    const GpuModel gpu_model = upload(gl(), model);
    const GpuOverlay gpu_overlay = upload(gl(), overlay);
    return picture_of(gl(), renderer, gpu_model, model, plain_scene(model, height_mm), {size, {3}}, &gpu_overlay);
  }
  Image without_line(PixelSize size = {160, 120}, double height_mm = 12) {
    const Model model = make_model({{"ball", ball({{}, 5})}});
    return draw(model, plain_scene(model, height_mm), size, 3);
  }
};

/// How many rows of ink the middle column holds.
double line_width(const Image& with, const Image& without) {
  const Colour ink = colour_of(LineKind::contour);
  const double of_ink[3] = {255 * ink.red, 255 * ink.green, 255 * ink.blue};
  double rows = 0;
  for (int y = 0; y < with.height; ++y) {
    double change = 0, whole = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double ground = without.pixel(with.width / 2, y)[c];
      change += std::abs(with.pixel(with.width / 2, y)[c] - ground);
      whole += std::abs(of_ink[c] - ground);
    }
    rows += change / whole;
  }
  return rows;
}

double change(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
  return sum;
}

TEST_F(Lines, HaveOneWidthHoweverNearOneIs) {
  const double far_off = line_width(with_line(5.03, LineKind::contour, {160, 120}, 24), without_line({160, 120}, 24));
  const double near = line_width(with_line(5.03, LineKind::contour, {160, 120}, 6), without_line({160, 120}, 6));
  EXPECT_NEAR(far_off, 1.3, 0.4);
  EXPECT_NEAR(near, far_off, 0.2);
}

TEST_F(Lines, OnTheSurfaceAreSeenWhole) {
  const Image plain = without_line();
  // The line pokes out of the ball in its middle and lies within it at its ends, where the ball is 4 mm high: a chord
  // at y = 4.0.
  const double above = change(with_line(5.03, LineKind::boundary_edge), plain);
  const double within = change(with_line(3.0, LineKind::boundary_edge), plain);
  const double behind = change(with_line(-5.03, LineKind::boundary_edge), plain);
  EXPECT_GT(above, 0);
  EXPECT_GT(within, 0) << "a hint of what is hidden";
  EXPECT_LT(within, 0.6 * above);
  EXPECT_NEAR(behind, within, 0.1 * within);
  EXPECT_EQ(change(with_line(3.0, LineKind::contour), plain), 0) << "hidden contours would only clutter the picture";
}

TEST_F(Lines, EndsThatAreEqualMakeADot) {
  const Model model = make_model({{"ball", ball({{}, 5})}});
  Overlay overlay;
  const glm::vec3 place(metres_per_mm * (glm::dvec3(0, 5.03, 0) - model.origin_mm));
  overlay.lines.push_back({LineKind::measure, "", {place, place}});
  context().make_current();
  Renderer renderer(gl(), ShaderLibrary{});
  const GpuModel gpu_model = upload(gl(), model);
  const GpuOverlay gpu_overlay = upload(gl(), overlay);
  const Image drawn =
      picture_of(gl(), renderer, gpu_model, model, plain_scene(model, 12), {{160, 120}, {3}}, &gpu_overlay);
  EXPECT_GT(change(drawn, without_line()), 100);
  EXPECT_GT(drawn.pixel(80, 60)[0], 230) << "white";
}

TEST_F(Lines, GoWithTheirStructureAndTheSection) {
  const std::vector<NamedSurface> surfaces = {{"ring", faulty_ring()}};
  const Model model = make_model(surfaces);
  OverlaySource source;
  source.faulty_edges = faulty_edges(surfaces, model);
  context().make_current();
  Renderer renderer(gl(), ShaderLibrary{});
  const GpuModel gpu_model = upload(gl(), model);
  const GpuOverlay overlay = upload(gl(), make_overlay(source, OverlayChoice{.edges = true, .slab = {}}, model));
  const auto drawn = [&](const Scene& scene, const GpuOverlay* over) {
    return picture_of(gl(), renderer, gpu_model, model, scene, {{160, 120}, {1}}, over);
  };
  Scene scene = plain_scene(model, 14);
  EXPECT_NE(drawn(scene, &overlay), drawn(scene, nullptr));
  scene.looks[0].visible = false;
  EXPECT_EQ(drawn(scene, &overlay), drawn(scene, nullptr));
  scene.looks[0].visible = true;
  scene.section = Section{{0, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(drawn(scene, &overlay), drawn(scene, nullptr)) << "the faults are all on the buccal side";
}

std::size_t shaders_made = 0;
GLADapiproc create_shader = nullptr;
GLuint GLAD_API_PTR counted_create_shader(GLenum kind) {
  ++shaders_made;
  return reinterpret_cast<PFNGLCREATESHADERPROC>(create_shader)(kind);
}

TEST_F(Lines, UploadingAndDrawingNeverCompile) {
  context().make_current();
  Gl counted = gl();
  create_shader = reinterpret_cast<GLADapiproc>(counted.CreateShader);
  counted.CreateShader = counted_create_shader;
  shaders_made = 0;
  Renderer renderer(counted, ShaderLibrary{});
  const std::size_t at_first = shaders_made;
  EXPECT_GT(at_first, 0u);
  Scene scene = plain_scene(small_molar(), 30);
  for (int i = 0; i < 3; ++i) {
    scene.overlays = {.contours = true, .edges = true, .slab = static_cast<std::size_t>(20 + i)};
    scene.wire = i == 1;
    if (i == 2) scene.section = Section{{0, 0, 10}, {0, 1, 0}};
    scene.occlusion.on = i == 1;
    const Model model = make_model(small_molar_surfaces());
    const GpuModel gpu_model = upload(counted, model);
    const GpuOverlay overlay = upload(counted, make_overlay(small_molar_overlays(), scene.overlays, model));
    picture_of(counted, renderer, gpu_model, model, scene, {{60, 40}, {1}}, &overlay);
  }
  EXPECT_EQ(shaders_made, at_first);
}

}  // namespace
}  // namespace odontoscope::testing_support
