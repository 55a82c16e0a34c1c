// The part of the Python package that draws: pictures as `odontoscope render` makes them, and the page of `odontoscope web`. A module of its own,
// so that whoever only computes needs neither OpenGL nor what it brings along.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/model_page.h"
#include "engine/app/scene_words.h"
#include "engine/app/wall_marks.h"
#include "engine/gpu/context.h"
#include "engine/picture/png.h"
#include "engine/scene/overlay.h"
#include "engine/scene/scene_json.h"
#include "engine/view/offscreen.h"
#include "python/binding/arrays.h"
#include "python/binding/errors.h"
#include "python/binding/parts.h"
#include "python/binding/watched.h"
#include "recon/core/atomic_file.h"

namespace odontoscope::python {
namespace {

struct DrawWords {
  app::SceneWords scene;
  PictureFormat format;
  PictureOptions picture;   // by it
  Backend backend = Backend::automatic;
  std::string save_scene;   // empty: nowhere
};

template <class Value>
void take(const py::dict& given, const char* word, Value& to) {
  to = given[word].cast<Value>();
}

app::SceneWords scene_words(const py::dict& given) {
  app::SceneWords words;
  take(given, "scene", words.scene_file);
  take(given, "camera", words.camera_file);
  take(given, "view", words.view);
  take(given, "parallel", words.parallel);
  take(given, "zoom", words.zoom);
  take(given, "hide", words.hide);
  take(given, "opacity", words.opacity);
  take(given, "colour", words.colour);
  take(given, "section", words.section);
  take(given, "cap", words.cap);
  take(given, "cull", words.back_faces);
  take(given, "background", words.background);
  take(given, "overlay", words.overlays);
  take(given, "occlusion", words.occlusion);
  take(given, "wire", words.wire);
  take(given, "wall_depth", words.wall_depth);
  return words;
}

DrawWords draw_words(const py::dict& given) {
  DrawWords words;
  words.scene = scene_words(given);
  words.format = app::picture_format(given["size"].cast<std::string>(), given["samples"].cast<std::optional<int>>(), words.scene.scene_file, words.picture.size);
  words.picture = {.size = {words.format.width, words.format.height}, .render = {.side = app::side_of(words.format)}};
  words.backend = backend_named(given["backend"].cast<std::string>());
  if (words.backend == Backend::window)
    throw UsageError("backend=\"window\" opens a window, and the package has none", "Say auto, egl or osmesa");
  take(given, "save_scene", words.save_scene);
  app::refuse_senseless(words.scene);
  return words;
}

WrittenModel written(const Model& model) {
  return model.dt ? WrittenModel(model.dt->reconstruction) : WrittenModel(model.db->reconstruction);
}

/// Contours and tetrahedra are copied only if they are to be seen.
OverlaySource overlays_of(const Model& model, bool wanted) {
  OverlaySource source;
  if (!wanted) return source;
  if (model.contours) source.contours = *model.contours;
  if (model.dt)
    for (const Solid& solid : model.dt->reconstruction.solids) source.solids.push_back({solid.structure, solid.tetrahedra});
  return source;
}

Image drawn(const Model& given, const DrawWords& words, const Progress& progress) {
  const std::vector<NamedSurface> surfaces = app::surfaces_of(written(given));
  odontoscope::Model model = odontoscope::make_model(surfaces);
  OverlaySource source = overlays_of(given, !words.scene.overlays.empty() || !words.scene.scene_file.empty());
  source.faulty_edges = faulty_edges(surfaces, model);
  Scene scene = app::scene_from(words.scene, model, source, nullptr, words.picture.size);
  if (!words.scene.cap.empty() && !scene.section)
    throw UsageError("--cap " + words.scene.cap + ": nothing is cut open", "Say with --section where to cut.");
  if (scene.wall_depth) app::mark_wall_depths(model, surfaces, progress);
  progress.check();
  progress.tell("draw", 0);
  const std::unique_ptr<GlContext> context = make_context({.backend = words.backend});
  refuse_undrawable(context->gl(), words.picture.size, words.picture.render);
  Renderer renderer(context->gl(), shaders_from_environment());
  const GpuModel gpu_model = upload(context->gl(), model);
  const GpuOverlay overlay = upload(context->gl(), make_overlay(source, scene.overlays, model));
  Image image = picture_of(context->gl(), renderer, gpu_model, model, scene, words.picture, &overlay);
  scene.picture = words.format;
  if (!words.save_scene.empty()) write_files(std::vector<FileContent>{{words.save_scene, to_json(scene)}});
  return image;
}

/// (rows, columns, 4), the caller's own.
py::array array_of(Image&& image) {
  const auto kept_image = std::make_shared<Image>(std::move(image));
  const auto width = static_cast<py::ssize_t>(kept_image->width), height = static_cast<py::ssize_t>(kept_image->height);
  return py::array(py::dtype::of<std::uint8_t>(), {height, width, py::ssize_t{4}}, {4 * width, py::ssize_t{4}, py::ssize_t{1}},
                   kept_image->rgba.data(), kept(kept_image));
}

py::array picture(const Model& model, const py::dict& given, const py::object& listener) {
  const DrawWords words = draw_words(given);
  if (model.contours) app::refuse_unknown_structures(words.scene, *model.contours);
  return array_of(watched(listener, [&](const Progress& progress) { return drawn(model, words, progress); }));
}

/// Precondition: of shape (rows, columns, 4), which the package has seen to.
py::bytes png(const py::array_t<std::uint8_t, py::array::c_style>& pixels) {
  Image image(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)));
  std::copy_n(pixels.data(), image.rgba.size(), image.rgba.begin());
  std::string bytes;
  {
    const py::gil_scoped_release unlocked;
    bytes = png_bytes(image);
  }
  return bytes;
}

WebPage page_of(const Model& model, const Progress& progress) {
  WebPage page;
  const WrittenModel whole = written(model);
  app::add_ways(whole, page, progress);
  page.looks = app::looks_of(whole);
  progress.check();
  page.models.push_back(model.dt ? app::web_model_by_dt(model.dt->reconstruction, !model.dt->simplification.structures.empty(), {})
                                 : app::web_model_by_db(model.db->reconstruction, model.db->options.cases));
  return page;
}

py::bytes page(const Model& model, const std::string& title, const py::object& listener) {
  const EmbeddedPage shell = embedded_page();
  if (shell.html.empty())
    throw UsageError("this package was built without the web page: " + std::string(shell.why),
                     "Install Node.js 18 or newer with npm, see that the npm registry can be reached, and build again");
  return watched(listener, [&](const Progress& progress) {
    WebPage made = page_of(model, progress);
    made.title = title;
    return web_page(made, shell.html);
  });
}

void translate_graphics_error(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const GraphicsError& error) {
    raise_error("GraphicsError", error, error.cause());
  }
}

}  // namespace
}  // namespace odontoscope::python

PYBIND11_MODULE(_draw, module) {
  using namespace odontoscope::python;
  module.doc() = "Pictures and pages of Odontoscope; use the package odontoscope instead.";
  py::module_::import("odontoscope._core");   // the types
  translate_errors();
  py::register_exception_translator(&translate_graphics_error);
  module.def("check", [](const py::dict& words) { draw_words(words); });
  module.def("page", &page);
  module.def("picture", &picture);
  module.def("png", &png);
}
