// The part of the Python package that draws: pictures as `odontoscope render` makes them, and the page of `odontoscope web`. A module of its own,
// so that whoever only computes needs neither OpenGL nor what it brings along.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/app/lesson.h"
#include "engine/app/model_page.h"
#include "engine/figures/comparison_pictures.h"
#include "engine/gpu/context.h"
#include "engine/picture/png.h"
#include "python/binding/arrays.h"
#include "python/binding/errors.h"
#include "python/binding/parts.h"
#include "python/binding/pictures.h"
#include "python/binding/watched.h"
#include "recon/compare/compare.h"

namespace odontoscope::python {
namespace {

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

/// `lesson`: a file or a title, or empty; `beside`: what DB made of the same contours, if it is to be there.
WebPage page_of(const Model& model, const std::string& lesson, const std::optional<Model>& beside, const Progress& progress) {
  WebPage page;
  const WrittenModel whole = model.dt ? WrittenModel(model.dt->reconstruction) : WrittenModel(model.db->reconstruction);
  app::add_ways(whole, page, progress);
  page.looks = app::looks_of(whole);
  progress.check();
  page.models.push_back(model.dt ? app::web_model_by_dt(model.dt->reconstruction, !model.dt->simplification.structures.empty(), {})
                                 : app::web_model_by_db(model.db->reconstruction, model.db->options.cases));
  if (beside) page.models.push_back(app::web_model_by_db(beside->db->reconstruction, beside->db->options.cases));
  if (!lesson.empty()) {
    const app::CalledLesson called = app::lesson_called(lesson);
    page.lesson = to_json(called.tour);
    page.lesson_built_in = called.built_in;
  }
  return page;
}

py::bytes page(const Model& model, const std::string& title, const std::string& lesson, const std::optional<Model>& beside, const py::object& listener) {
  const EmbeddedPage shell = embedded_page();
  if (shell.html.empty())
    throw UsageError("this package was built without the web page: " + std::string(shell.why),
                     "Install Node.js 18 or newer with npm, see that the npm registry can be reached, and build again");
  if (beside && (!beside->db || model.db)) throw UsageError("db is what the DB method made, beside a model of DT", "Give reconstruct(..., method=\"db\")");
  return watched(listener, [&](const Progress& progress) {
    WebPage made = page_of(model, lesson, beside, progress);
    made.title = title;
    return web_page(made, shell.html);
  });
}

/// What a comparison shows of each method's model, drawn into it.
void add_pictures(const std::shared_ptr<Comparison>& comparison, const py::object& listener) {
  run_watched(listener, [&](const Progress& progress) {
    const std::unique_ptr<GlContext> context = make_context({.backend = Backend::automatic});
    figures::add_pictures(*comparison, context->gl(), progress);
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
  module.def("add_pictures", &add_pictures);
  module.def("anatomy_of_mesh", &anatomy_of_mesh);
  module.def("check", &refuse_senseless_pictures);
  module.def("gltf_extras", &gltf_extras);
  module.def("page", &page);
  module.def("pictures", &pictures);
  module.def("png", &png);
}
