#include "python/binding/pictures.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/app/data_colour_words.h"
#include "engine/app/model_page.h"
#include "engine/app/painter.h"
#include "engine/app/radiograph_options.h"
#include "engine/app/shown_values.h"
#include "engine/app/tour_cameras.h"
#include "engine/app/volume_look_words.h"
#include "engine/app/wall_marks.h"
#include "engine/app/whole_structures.h"
#include "engine/gpu/context.h"
#include "engine/picture/film_file.h"
#include "engine/scene/scene_json.h"
#include "python/binding/arrays.h"
#include "python/binding/session.h"
#include "python/binding/watched.h"
#include "recon/cavity/anatomy.h"
#include "recon/core/atomic_file.h"
#include "recon/core/lower_case.h"
#include "recon/output/anatomy_text.h"
#include "recon/volume/thresholds.h"

namespace odontoscope::python {
namespace {

struct PictureWords {
  app::SceneWords scene;
  app::VolumeLookWords look;
  app::RadiographWords radiograph;
  app::TourWords tour;
  std::string contact_sheet;              // empty: none
  std::string colour_by;                  // empty: as the scene says
  std::size_t frames = 0, turntable = 0;  // 0: not asked for
  PictureFormat format;
  PictureOptions picture;  // by it
  Backend backend = Backend::automatic;
  std::string save_scene;  // empty: nowhere
  bool sized = false;      // the call said how large

  bool on_tour() const { return !tour.line.empty(); }
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
  take(given, "wall_thickness", words.wall_thickness);
  return words;
}

app::RadiographWords radiograph_words(const py::dict& given) {
  app::RadiographWords words;
  take(given, "radiograph", words.on);
  take(given, "kv", words.kv);
  take(given, "beam", words.beam);
  take(given, "focus", words.focus);
  take(given, "tube", words.tube);
  take(given, "film", words.film);
  take(given, "pixel", words.pixel);
  take(given, "exposure", words.exposure);
  take(given, "inverted", words.inverted);
  take(given, "attenuation", words.attenuation);
  take(given, "grey", words.grey);
  return words;
}

bool wants_voxels(const PictureWords& words) { return app::wants_voxels(words.look, words.scene.scene_file); }

/// What the call alone tells to be wrong.
void refuse_senseless(const PictureWords& words) {
  app::refuse_senseless(words.scene);
  app::refuse_senseless(words.look);
  app::refuse_senseless(words.radiograph);
  app::refuse_senseless_colour_by(words.colour_by);
  const bool about_tour =
      words.frames > 0 || !words.contact_sheet.empty() || words.tour.reverse || words.tour.void_number > 1;
  if (!words.on_tour() && about_tour)
    throw UsageError("frames, contact_sheet, reverse and void are about a tour", "Say which line: tour=\"canal-1\"");
  if (words.on_tour() && words.turntable > 0) throw UsageError("tour and turntable both lead the camera", "Choose one");
  if (words.on_tour() && !words.scene.section.empty())
    throw UsageError("section: on a tour nothing is cut open", "Leave it out");
  if (words.radiograph.on) {
    app::refuse_words_about_pictures(words.scene, words.look);
    if (!words.colour_by.empty())
      throw UsageError("colour_by: a film has no surfaces to colour", "Leave it out, or radiograph");
    if (words.on_tour()) throw UsageError("radiograph and tour: no film lies in a canal", "Choose one");
    if (words.sized || !words.save_scene.empty())
      throw UsageError("size and save_scene: a film has no scene, and its size is told in mm",
                       "Give film=\"31x41\" and pixel=0.05");
  } else if (!words.radiograph.grey.empty() && !wants_voxels(words)) {
    throw UsageError("grey says what values mean, and none are shown", "Ask for radiograph=True or show=\"volume\"");
  }
  if (!words.contact_sheet.empty()) {
    app::refuse_too_large(app::sheet_from(words.contact_sheet), words.format.width, words.format.height);
    if (words.frames > 0)
      throw UsageError("frames: a contact sheet has as many pictures as it has places", "Leave it out");
  }
}

PictureWords understood(const py::dict& given) {
  constexpr PixelSize usual{1200, 900}, usual_on_sheet{320, 240};
  PictureWords words;
  words.scene = scene_words(given);
  words.radiograph = radiograph_words(given);
  take(given, "show", words.look.show);
  take(given, "cast", words.look.cast);
  take(given, "transfer", words.look.transfer);
  take(given, "slopes", words.look.slopes);
  take(given, "tour", words.tour.line);
  take(given, "void", words.tour.void_number);
  take(given, "reverse", words.tour.reverse);
  take(given, "contact_sheet", words.contact_sheet);
  take(given, "colour_by", words.colour_by);
  take(given, "frames", words.frames);
  take(given, "turntable", words.turntable);
  words.format = app::picture_format(given["size"].cast<std::string>(), given["samples"].cast<std::optional<int>>(),
                                     words.scene.scene_file, words.contact_sheet.empty() ? usual : usual_on_sheet);
  words.picture = {.size = {words.format.width, words.format.height}, .render = {.side = app::side_of(words.format)}};
  words.backend = backend_named(given["backend"].cast<std::string>());
  if (words.backend == Backend::window)
    throw UsageError("backend=\"window\" opens a window, and the package has none", "Say auto, egl or osmesa");
  take(given, "save_scene", words.save_scene);
  words.sized = !given["size"].cast<std::string>().empty();
  refuse_senseless(words);
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
    for (const Solid& solid : model.dt->reconstruction.solids)
      source.solids.push_back({solid.structure, solid.tetrahedra});
  return source;
}

/// The grey values around the model, if any are to be seen.
void add_values(const Model& model, const PictureWords& words, app::Shown& shown) {
  const bool voxels = wants_voxels(words),
             cap = !words.scene.cap.empty() || !words.colour_by.empty() || !words.scene.scene_file.empty();
  if (!model.origin || !model.origin->volume || !(voxels || cap)) return;
  const Volume& volume = *model.origin->volume;
  const Box bounds = app::bounds_of(*model.contours);
  if (voxels) shown.greys = grey_anchors(volume);
  shown.values =
      std::make_shared<const ValueGrid>(value_grid(volume, voxels ? app::with_margin(bounds, volume) : bounds));
  for (const auto& [structure, iso] : model.origin->facts->isos) shown.isos.push_back({structure, iso});
}

app::Shown shown_of(const Model& model, const PictureWords& words) {
  app::Shown shown;
  shown.surfaces = app::surfaces_of(written(model));
  shown.model = odontoscope::make_model(shown.surfaces);
  shown.overlays = overlays_of(model, !words.scene.overlays.empty() || !words.scene.scene_file.empty());
  shown.overlays.faulty_edges = faulty_edges(shown.surfaces, shown.model);
  add_values(model, words, shown);
  if (model.dt) shown.proven = app::proven_by(model.dt->reconstruction);
  return shown;
}

app::Shown shown_of(const VolumeImage& image, const PictureWords& words) {
  if (!wants_voxels(words))
    throw UsageError("nothing says where in the volume the surface lies",
                     "Give iso for an image, label for a label map, or show=\"volume\"");
  if (looks_like_labels(*image.volume))
    throw UsageError("the volume looks like a label map, whose values are no grey", "Say with label what is solid");
  app::VoxelsAlone voxels = app::voxels_alone(*image.volume, {});
  app::Shown shown;
  shown.surfaces.push_back({"volume", app::box_surface(voxels.dense)});
  shown.model = odontoscope::make_model(shown.surfaces);
  shown.overlays.faulty_edges = faulty_edges(shown.surfaces, shown.model);
  shown.values = std::move(voxels.values);
  shown.greys = voxels.greys;
  shown.only_voxels = true;
  return shown;
}

app::Shown shown_in(const Seen& seen, const PictureWords& words, app::Session& session) {
  if (const auto* model = std::get_if<Model>(&seen)) return shown_of(*model, words);
  if (const auto* image = std::get_if<VolumeImage>(&seen)) return shown_of(*image, words);
  return app::shown_from(std::get<std::string>(seen), {}, {}, session);
}

std::vector<Image> along_tour(const app::Shown& shown, const Scene& scene, const app::Film& film,
                              const PictureWords& words, app::Painter& painter) {
  if (!words.contact_sheet.empty())
    return {app::sheet_of(shown, scene, film, app::sheet_from(words.contact_sheet), painter)};
  std::vector<Image> frames;
  for (std::size_t i = 0; i < words.frames; ++i)
    frames.push_back(
        painter.draw(app::frame_of(scene, shown, film, app::moment(film, i, words.frames)), i, words.frames));
  return frames;
}

std::vector<Image> all_around(const Scene& scene, const PictureWords& words, app::Painter& painter) {
  const std::size_t count = std::max<std::size_t>(words.turntable, 1);
  std::vector<Image> images;
  for (std::size_t i = 0; i < count; ++i) {
    Scene turned = scene;
    if (words.turntable > 0) turned.camera = app::turned(scene.camera, i, count);
    images.push_back(painter.draw(turned, i, count));
  }
  return images;
}

/// What is drawn, and with what: everything but the pictures themselves.
struct Stage {
  Stage(const Seen& seen, const PictureWords& words, app::Session& session)
      : shown(shown_in(seen, words, session)),
        scene(app::scene_from(words.scene, shown.model, shown.overlays, shown.values.get(), words.picture.size)) {
    app::show_volume({words.look, words.radiograph.grey, words.radiograph.kv, words.scene.opacity,
                      !words.scene.background.empty() || !words.scene.scene_file.empty()},
                     shown, scene, session);
    app::colour_by_data(words.colour_by, words.scene.opacity, shown, scene, session);
    app::refuse_cap_without_section(words.scene, scene);
    if (words.on_tour()) film.emplace(app::film_of(shown, words.tour, session));
    app::mark_walls(scene, shown.model, shown.surfaces, session.progress());
    session.progress().check();
    context = make_context({.backend = words.backend});
    refuse_undrawable(context->gl(), words.picture.size, words.picture.render);
    renderer.emplace(context->gl(), shaders_from_environment());
    painter.emplace(words.picture, context->gl(), *renderer, shown, scene, session);
  }
  app::Shown shown;
  Scene scene;
  std::optional<app::Film> film;  // on a tour
  std::unique_ptr<GlContext> context;
  std::optional<Renderer> renderer;
  std::optional<app::Painter> painter;
};

std::vector<Image> drawn(const Seen& seen, const PictureWords& words, app::Session& session) {
  Stage stage(seen, words, session);
  std::vector<Image> images = stage.film ? along_tour(stage.shown, stage.scene, *stage.film, words, *stage.painter)
                                         : all_around(stage.scene, words, *stage.painter);
  stage.scene.picture = words.format;
  if (!words.save_scene.empty()) write_files(std::vector<FileContent>{{words.save_scene, to_json(stage.scene)}});
  return images;
}

double filmed(const Seen& seen, const std::string& file, const PictureWords& words, app::Session& session) {
  constexpr double rate = 30;  // pictures a second
  constexpr std::size_t most = 3600;
  Stage stage(seen, words, session);
  const app::Film& tour = *stage.film;
  const auto as_it_is = static_cast<std::size_t>(std::lround(rate * tour.tour.seconds())) + 1;
  const std::size_t count = words.frames > 0 ? words.frames : std::min(as_it_is, most);
  FilmMaker maker(file, {words.format.width, words.format.height, rate});
  for (std::size_t i = 0; i < count; ++i)
    maker.add(stage.painter->draw(app::frame_of(stage.scene, stage.shown, tour, app::moment(tour, i, count)), i, count),
              session.progress());
  write_files(std::vector<FileContent>{{file, maker.finish(session.progress())}});
  return static_cast<double>(count) / rate;
}

std::vector<Image> films(const Seen& seen, const PictureWords& words, app::Session& session) {
  std::vector<Image> images;
  const auto keep = [&](Image&& film) { images.push_back(std::move(film)); };
  const app::RadiographPose pose{words.scene.view.empty() ? NamedView::buccal : view_named(words.scene.view),
                                 words.scene.hide, std::max(static_cast<int>(words.turntable), 1)};
  if (const auto* image = std::get_if<VolumeImage>(&seen)) {
    app::radiographs(words.radiograph, *image->volume, image->volume->source, pose, session, keep);
    return images;
  }
  if (!words.radiograph.grey.empty())
    throw UsageError("grey is about a radiograph through the voxels of a volume",
                     "Leave it out, or leave out iso and label");
  const auto* file = std::get_if<std::string>(&seen);
  app::radiographs(words.radiograph, shown_in(seen, words, session), file ? *file : "", pose, session, keep);
  return images;
}

/// (rows, columns, 4), the caller's own.
py::array array_of(Image&& image) {
  const auto kept_image = std::make_shared<Image>(std::move(image));
  const auto width = static_cast<py::ssize_t>(kept_image->width), height = static_cast<py::ssize_t>(kept_image->height);
  return py::array(py::dtype::of<std::uint8_t>(), {height, width, py::ssize_t{4}},
                   {4 * width, py::ssize_t{4}, py::ssize_t{1}}, kept_image->rgba.data(), kept(kept_image));
}

}  // namespace

void refuse_senseless_pictures(const py::dict& words) { understood(words); }

py::list pictures(const Seen& seen, const py::dict& given, const py::object& listener) {
  const PictureWords words = understood(given);
  const auto* model = std::get_if<Model>(&seen);
  if (model && model->contours && !words.radiograph.on) app::refuse_unknown_structures(words.scene, *model->contours);
  QuietSession session;
  std::vector<Image> images = watched(listener, [&](const Progress& progress) {
    return words.radiograph.on ? films(seen, words, session.watched_by(progress))
                               : drawn(seen, words, session.watched_by(progress));
  });
  session.warn();
  py::list arrays;
  for (Image& image : images) arrays.append(array_of(std::move(image)));
  return arrays;
}

double film(const Seen& seen, const std::string& file, const py::dict& given, const py::object& listener) {
  const PictureWords words = understood(given);
  const std::string ending = lower_case(std::filesystem::path(file).extension().string());
  if (std::find(film_endings().begin(), film_endings().end(), ending) == film_endings().end())
    throw UsageError(file + " is no film by its name", "Call it something.mp4 or something.webm");
  if (words.format.width % 2 != 0 || words.format.height % 2 != 0)
    throw UsageError("size: a film's width and height are even", "Add a pixel: colour is stored for two by two");
  need_ffmpeg(file);
  QuietSession session;
  const double seconds = watched(
      listener, [&](const Progress& progress) { return filmed(seen, file, words, session.watched_by(progress)); });
  session.warn();
  return seconds;
}

std::pair<std::string, std::string> anatomy_of_mesh(const std::string& file, const py::object& listener) {
  QuietSession session;
  return watched(listener, [&](const Progress& progress) {
    const app::Shown shown = app::shown_from(file, {}, {}, session.watched_by(progress));
    const std::vector<NamedMesh> whole = app::whole_structures(shown.surfaces);
    const Anatomy anatomy = measure_anatomy(app::looked_at(whole), progress, shown.slices);
    return std::pair(anatomy_json(anatomy, file), anatomy_csv(anatomy));
  });
}

GlbOptions gltf_extras(const Model& model, bool tours, bool hotspots, const py::object& listener) {
  QuietSession session;
  return watched(listener, [&](const Progress& progress) {
    GlbOptions options;
    const WrittenModel whole = written(model);
    const CentreLines lines = app::lines_inside(whole, tours ? "tours" : "hotspots", session.watched_by(progress));
    if (tours) options.paths = app::tour_cameras(whole, lines);
    if (hotspots) options.hotspots = app::hotspots_of(lines);
    return options;
  });
}

}  // namespace odontoscope::python
