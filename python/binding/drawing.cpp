// The part of the Python package that draws: pictures as `odontoscope render` makes them, and the page of `odontoscope
// web`. A module of its own, so that whoever only computes needs neither OpenGL nor what it brings along.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "engine/app/called_lesson.h"
#include "engine/app/model_page.h"
#include "engine/app/shown_values.h"
#include "engine/app/volume_look_words.h"
#include "engine/app/web_volume.h"
#include "engine/figures/comparison_pictures.h"
#include "engine/gpu/context.h"
#include "engine/picture/png.h"
#include "python/binding/arrays.h"
#include "python/binding/errors.h"
#include "python/binding/parts.h"
#include "python/binding/pictures.h"
#include "python/binding/session.h"
#include "python/binding/watched.h"
#include "recon/compare/compare.h"
#include "recon/volume/thresholds.h"

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

struct PageWords {
  std::string title, lesson, language, grey;
  app::VolumeLookWords look;
  bool with_volume() const { return !look.show.empty() && look.show != "surfaces"; }
};

PageWords page_words(const py::dict& given) {
  PageWords words;
  const auto text = [&](const char* word) { return given[word].cast<std::string>(); };
  words.title = text("title");
  words.lesson = text("lesson");
  words.language = text("language");
  words.grey = text("grey");
  words.look = {text("show"), text("cast"), text("transfer"), text("slopes")};
  app::refuse_senseless(words.look);
  app::greys_from(words.grey);
  if (!words.with_volume() && (words.look.any_of_volume() || !words.grey.empty()))
    throw UsageError("cast, transfer, slopes and grey are about a volume's grey values",
                     "Put them into the page: show=\"volume\" or show=\"both\"");
  return words;
}

void add_volume(const Model& model, const PageWords& words, Scene& scene, WebPage& page, app::Session& session) {
  add_greys(app::page_greys(*model.origin->volume, *model.contours, *model.origin->facts), words.look, words.grey,
            scene, page, session);
}

/// `beside`: what DB made of the same contours, if it is to be there.
WebPage page_of(const Model& model, const PageWords& words, const std::optional<Model>& beside, app::Session& session) {
  WebPage page;
  const WrittenModel whole = model.dt ? WrittenModel(model.dt->reconstruction) : WrittenModel(model.db->reconstruction);
  app::add_ways(whole, page, session.progress());
  Scene scene = app::usual_scene_of(whole);
  if (words.with_volume()) add_volume(model, words, scene, page, session);
  page.looks = app::looks_of(scene);
  session.progress().check();
  page.models.push_back(
      model.dt ? app::web_model_by_dt(model.dt->reconstruction, !model.dt->simplification.structures.empty(), {})
               : app::web_model_by_db(model.db->reconstruction, model.db->options.cases));
  if (beside) page.models.push_back(app::web_model_by_db(beside->db->reconstruction, beside->db->options.cases));
  return page;
}

WebPage page_of(const VolumeImage& image, const PageWords& words, app::Session& session) {
  return app::page_of_voxels(app::voxels_alone(*image.volume, app::page_values), words.look, words.grey, session);
}

void refuse_without_values(const Model& model, const PageWords& words) {
  if (words.with_volume() && (!model.origin || !model.origin->volume))
    throw UsageError("only a model of a volume has grey values to show",
                     "Leave show out, or make it from the volume with iso");
}

void refuse_without_values(const VolumeImage& image, const PageWords& words) {
  if (words.look.show != "volume")
    throw UsageError("nothing says where in the volume the surface lies",
                     "Say show=\"volume\", or make a model of it with iso or label");
  if (looks_like_labels(*image.volume))
    throw UsageError("the volume looks like a label map, whose values are no grey", "Say with label what is solid");
}

py::bytes page(const std::variant<Model, VolumeImage>& shown, const py::dict& given, const std::optional<Model>& beside,
               const py::object& listener) {
  const PageWords words = page_words(given);
  std::visit([&](const auto& one) { refuse_without_values(one, words); }, shown);
  const EmbeddedPage shell = embedded_page();
  if (shell.html.empty())
    throw UsageError("this package was built without the web page: " + std::string(shell.why),
                     "Install Node.js 18 or newer with npm, see that the npm registry can be reached, and build again");
  const auto* model = std::get_if<Model>(&shown);
  if (beside && (!beside->db || !model || model->db))
    throw UsageError("db is what the DB method made, beside a model of DT", "Give reconstruct(..., method=\"db\")");
  QuietSession session;
  std::string html = watched(listener, [&](const Progress& progress) {
    app::Session& by = session.watched_by(progress);
    WebPage made = model ? page_of(*model, words, beside, by) : page_of(std::get<VolumeImage>(shown), words, by);
    made.title = words.title;
    made.language = app::language_in_page(words.language);
    if (!words.lesson.empty()) {
      const app::CalledLesson called = app::lesson_called(words.lesson);
      made.lesson = to_json(called.lesson);
      made.lesson_built_in = called.built_in;
    }
    return web_page(made, shell.html);
  });
  session.warn();
  return html;
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
  py::module_::import("odontoscope._core");  // the types
  translate_errors();
  py::register_exception_translator(&translate_graphics_error);
  module.def("add_pictures", &add_pictures);
  module.def("anatomy_of_mesh", &anatomy_of_mesh);
  module.def("check", &refuse_senseless_pictures);
  module.def("film", &film);
  module.def("gltf_extras", &gltf_extras);
  module.def("page", &page);
  module.def("pictures", &pictures);
  module.def("png", &png);
}
