#include "engine/app/radiograph_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <map>
#include <numeric>

#include "engine/app/options.h"
#include "engine/app/tell_volume.h"
#include "engine/app/words.h"
#include "engine/scene/volume_look.h"
#include "recon/radiograph/film.h"
#include "recon/radiograph/length_inside.h"
#include "recon/radiograph/sum_through.h"
#include "recon/radiograph/tissue.h"
#include "recon/volume/read_volume.h"

namespace odontoscope::app {
namespace {

/// From the focus to the film, as of a long tube.
constexpr double usual_focus_mm = 400;
constexpr double usual_pixel_mm = 0.05;
/// Room round a shadow that a usual film is too small for.
constexpr double film_margin = 1.1;
constexpr double steepest_deg = 60;
constexpr double longest_mm = 1e6;
constexpr std::size_t most_pixels = 40'000'000;

template <class Number>
bool all_of_it(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return !text.empty() && error == std::errc{} && end == text.data() + text.size();
}

/// Two finite numbers with `between` in between.
std::optional<glm::dvec2> two_numbers(const std::string& text, char between) {
  const std::size_t middle = text.find(between);
  glm::dvec2 both{0};
  const std::string_view all(text);
  if (middle == std::string::npos || !all_of_it(all.substr(0, middle), both.x) ||
      !all_of_it(all.substr(middle + 1), both.y))
    return std::nullopt;
  return std::isfinite(both.x) && std::isfinite(both.y) ? std::optional(both) : std::nullopt;
}

glm::dvec2 tube_from(const std::string& text) {
  if (text.empty()) return {0, 0};
  const auto both = two_numbers(text, ',');
  if (both && std::abs(both->x) <= steepest_deg && std::abs(both->y) <= steepest_deg) return *both;
  throw UsageError(fmt::format("--tube {}: that is no way to swing a tube", text),
                   fmt::format("Give degrees to the right and upwards, {:g} at most: --tube 20,0", steepest_deg));
}

std::optional<glm::dvec2> film_from(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto both = two_numbers(text, 'x');
  if (both && std::min(both->x, both->y) > 0 && std::max(both->x, both->y) <= longest_mm) return both;
  throw UsageError(fmt::format("--film {}: that is no size of a film", text),
                   "Give width and height in mm: --film 31x41");
}

/// 1/mm, by structure.
std::map<std::string, double> attenuations_from(const std::vector<std::string>& words, double energy_kev) {
  std::map<std::string, double> found;
  for (const std::string& text : words) {
    const std::size_t sign = std::min(text.rfind('='), text.size());
    const std::string value = sign < text.size() ? text.substr(sign + 1) : std::string();
    double number = 0;
    if (const auto tissue = tissue_called(value))
      number = linear_attenuation(*tissue, energy_kev);
    else if (value == "air")
      number = 0;
    else if (sign == 0 || !all_of_it(std::string_view(value), number) || !(number >= 0 && number <= longest_mm)) {
      std::vector<std::string> names{"air"};
      for (const Tissue& known : known_tissues()) names.push_back(known.name);
      throw UsageError(fmt::format("--attenuation {}: that is no structure with its attenuation", text),
                       fmt::format("Give 1/mm, as in crown=0.4, or a tissue: {}.", fmt::join(names, ", ")));
    }
    found[text.substr(0, sign)] = number;
  }
  return found;
}

Point3 point(const glm::dvec3& place) { return {place.x, place.y, place.z}; }
glm::dvec3 vector(const Point3& place) { return {place.x, place.y, place.z}; }

/// What is shone through, by the places that may cast the edge of its shadow.
struct Extent {
  std::vector<glm::dvec3> places;
  glm::dvec3 centre{0};
};

/// The tube looks at the middle of it; the film stands at right angles to the view, close behind it, its own middle in
/// the shadow of that middle.
FilmView film_view(const RadiographWords& words, NamedView from, double turn_deg, const Extent& extent) {
  const AnatomicalFrame frame;
  const ViewDirection straight = direction_of(from, frame);
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(turn_deg), frame.occlusal);
  const auto turned = [](const glm::dmat4& by, const glm::dvec3& way) { return glm::dvec3(by * glm::dvec4(way, 0)); };
  const glm::dvec3 viewer = turned(turn, straight.towards_eye);
  const glm::dvec3 upwards = turned(turn, straight.up), right = glm::normalize(glm::cross(upwards, viewer)),
                   up = glm::cross(viewer, right);
  const glm::dvec2 swing = glm::radians(tube_from(words.tube));
  const glm::dvec3 tube =
      turned(glm::rotate(glm::dmat4(1), swing.x, up), turned(glm::rotate(glm::dmat4(1), -swing.y, right), viewer));
  double behind = 0;
  for (const glm::dvec3& place : extent.places) behind = std::max(behind, glm::dot(extent.centre - place, viewer));

  FilmView view;
  view.right = point(right);
  view.up = point(up);
  view.beam = words.beam == "parallel" ? FilmView::Beam::parallel : FilmView::Beam::cone;
  view.towards_tube = point(tube);
  const double way = behind / glm::dot(tube, viewer);  // along the central ray, from the middle to the film
  view.centre = point(extent.centre - way * tube);
  view.focus = point(vector(view.centre) + words.focus.value_or(usual_focus_mm) * tube);
  return view;
}

/// Half width and height of the shadow about the film's centre; refuses a focus within or behind.
glm::dvec2 shadow(const FilmView& view, const Extent& extent) {
  const glm::dvec3 normal = vector(view.towards_viewer()), centre = vector(view.centre), focus = vector(view.focus);
  glm::dvec2 half{0};
  for (const glm::dvec3& place : extent.places) {
    glm::dvec3 seen = place + glm::dot(centre - place, normal) / glm::dot(vector(view.towards_tube), normal) *
                                  vector(view.towards_tube);
    if (view.beam == FilmView::Beam::cone) {
      const double far = glm::dot(focus - place, normal), film = glm::dot(focus - centre, normal);
      if (!(far > 1e-2 * film))
        throw UsageError("the tube stands within or behind what it shines through", "Move it away with --focus MM.");
      seen = focus + film / far * (place - focus);
    }
    half = glm::max(half, glm::abs(glm::dvec2(glm::dot(seen - centre, vector(view.right)),
                                              glm::dot(seen - centre, vector(view.up)))));
  }
  return half;
}

/// Lays the pixels; tells where a usual film would be too small.
FilmView with_pixels(const RadiographWords& words, FilmView view, const Extent& extent, Session& session, bool tell) {
  glm::dvec2 film = film_from(words.film).value_or(usual_film_mm);
  double pixel = words.pixel.value_or(usual_pixel_mm);
  const glm::dvec2 needed = 2.0 * shadow(view, extent);
  if (words.film.empty() && (needed.x > film.x || needed.y > film.y)) {
    film = film_margin * needed;
    if (!words.pixel) pixel = std::max(pixel, std::max(film.x, film.y) / 1000);
    if (tell)
      session.console.say(
          fmt::format("  its shadow is larger than a film of {:g} x {:g} mm; the film is made {} x {} mm",
                      usual_film_mm.x, usual_film_mm.y, measured(film.x), measured(film.y)));
  }
  const glm::dvec2 count = glm::round(film / pixel);
  if (!(std::min(count.x, count.y) >= 1 && std::max(count.x, count.y) <= most_picture_side &&
        count.x * count.y <= static_cast<double>(most_pixels)))
    throw UsageError(fmt::format("a film of {} x {} mm has {:.0f} x {:.0f} pixels of {} mm", measured(film.x),
                                 measured(film.y), count.x, count.y, measured(pixel)),
                     fmt::format("Choose --film and --pixel so that there are 1 to {} a side, and {} in all at most.",
                                 most_picture_side, most_pixels));
  view.columns = static_cast<int>(count.x);
  view.rows = static_cast<int>(count.y);
  view.pixel = pixel;
  return view;
}

Image image_of(const FilmMap& attenuation, const RadiographWords& words) {
  const std::vector<std::uint8_t> shown =
      greys(attenuation, {.times = words.exposure.value_or(1), .inverted = words.inverted});
  Image image(attenuation.width, attenuation.height);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) image.rgba[4 * i + channel] = shown[i];
    image.rgba[4 * i + 3] = 255;
  }
  return image;
}

/// All films of what `attenuation` says to be swallowed on the way to one.
template <class Attenuation>
void take_films(const RadiographWords& words, const RadiographPose& pose, const Extent& extent, Session& session,
                const TakeFilm& take, Attenuation attenuation) {
  double most = 0;
  for (int i = 0; i < pose.turns; ++i) {
    session.progress().tell("radiograph", static_cast<double>(i) / pose.turns);
    const FilmView view =
        with_pixels(words, film_view(words, pose.view, 360.0 * i / pose.turns, extent), extent, session, i == 0);
    const FilmMap map = attenuation(view);
    for (const double value : map.values) most = std::max(most, value);
    take(image_of(map, words));
  }
  session.console.say(fmt::format(
      "  black where nothing is swallowed{}, white from attenuation {:g} on; the most here is {}",
      words.exposure ? fmt::format(" (attenuation {} at this exposure)", measured(std::log(*words.exposure))) : "",
      Exposure::usual_latitude + std::log(words.exposure.value_or(1)), measured(most)));
}

// --- solids --------------------------------------------------------------------------------------------------------

struct SolidSurfaces {
  std::string name;
  std::vector<const SurfaceMesh*> surfaces;
  double attenuation = 0;  // 1/mm
};

void refuse_where_material_is_unknown(const NamedSurface& named, const std::string& file) {
  const SurfaceReport report = inspect(weld(named.surface));
  Place place;
  place.file = file;
  constexpr const char* remedy =
      "A radiograph needs solids that say where material is. Mend the mesh, or give the contours that it was made "
      "from.";
  if (report.boundary_edges + report.nonmanifold_edges > 0)
    throw InputError(
        "open-surface", place,
        fmt::format("\"{}\" is not closed: {}", named.structure, fmt::join(defects_in_words(report), ", ")), remedy);
  double volume = 0;
  for (const Shell& shell : report.shells) volume += shell.volume;
  if (report.misoriented_edges > 0 || (named.cavity ? volume > 0 : volume < 0))
    throw InputError("misoriented-surface", place,
                     fmt::format("\"{}\" is wound the wrong way, or both ways", named.structure), remedy);
}

std::vector<SolidSurfaces> solids_of(const Shown& shown, const std::string& file,
                                     const std::vector<std::string>& hidden_ones) {
  std::vector<SolidSurfaces> solids;
  for (const NamedSurface& surface : shown.surfaces) {
    if (!shown.proven) refuse_where_material_is_unknown(surface, file);
    const std::string& name = surface.solid.empty() ? surface.structure : surface.solid;
    auto at =
        std::find_if(solids.begin(), solids.end(), [&](const SolidSurfaces& solid) { return solid.name == name; });
    if (at == solids.end()) at = solids.insert(solids.end(), {name, {}});
    at->surfaces.push_back(&surface.surface);
  }
  for (const std::string& hidden : hidden_ones) {
    const auto at =
        std::find_if(solids.begin(), solids.end(), [&](const SolidSurfaces& solid) { return solid.name == hidden; });
    if (at == solids.end())
      throw UsageError(fmt::format("--hide: there is no solid \"{}\" left", hidden),
                       "A radiograph leaves out whole solids, with their cavities.");
    solids.erase(at);
  }
  if (solids.empty()) throw UsageError("--hide leaves nothing to shine through");
  return solids;
}

void choose_attenuation(std::vector<SolidSurfaces>& solids, const RadiographWords& words, double energy_kev) {
  std::map<std::string, double> told = attenuations_from(words.attenuation, energy_kev);
  for (SolidSurfaces& solid : solids) {
    if (const auto own = told.extract(solid.name))
      solid.attenuation = own.mapped();
    else if (const auto tissue = tissue_called(solid.name))
      solid.attenuation = linear_attenuation(*tissue, energy_kev);
    else
      throw UsageError(
          fmt::format("what tissue is \"{}\"? Its name does not say", solid.name),
          fmt::format("Say it: --attenuation \"{}\"=dentine, or a number of your own in 1/mm.", solid.name));
  }
  for (const auto& [name, value] : told) throw UsageError(fmt::format("--attenuation: there is no solid \"{}\"", name));
}

// --- voxels --------------------------------------------------------------------------------------------------------

void refuse_words_about_solids(const RadiographWords& words, const RadiographPose& pose) {
  if (!words.attenuation.empty())
    throw UsageError("--attenuation is about solids, and a volume without --iso has none",
                     "Say with --grey AIR,DENTINE what its values mean.");
  if (!pose.hidden.empty()) throw UsageError("--hide: a volume without --iso has no solids");
}

void through_file(const RadiographWords& words, const RadiographInput& input, const RadiographPose& pose,
                  Session& session, const TakeFilm& take) {
  refuse_words_about_solids(words, pose);
  if (input.volume.reshape.upright || input.volume.reshape.resample)
    throw UsageError("--upright and --resample need a surface", "Say with --iso where it lies.");
  const VolumeRequest request = understood(input.volume);
  Volume volume = read_volume(input.file, request.read, session.progress());
  tell_volume(input.file, volume, session.console);
  crop_told(volume, request.reshape, session.console);
  radiographs(words, volume, input.file, pose, session, take);
}

}  // namespace

bool RadiographWords::any() const {
  return kv != RadiographWords{}.kv || !beam.empty() || focus || !tube.empty() || !film.empty() || pixel || exposure ||
         inverted || !attenuation.empty();
}

void add_radiograph_options(CLI::App& parser, RadiographWords& words) {
  const std::string group = "Radiograph";
  const auto positive = CLI::Range(1e-6, longest_mm).description("");
  parser.add_flag("--radiograph", words.on, "An X-ray film instead; of a volume without --iso through its voxels")
      ->group(group);
  parser.add_option("--kv", words.kv, "Of the tube; half of it is taken as the rays' energy")
      ->type_name("KV")
      ->check(CLI::Range(least_kv, most_kv).description(""))
      ->capture_default_str()
      ->group(group);
  parser.add_option("--beam", words.beam, "cone (default) or parallel")
      ->type_name("KIND")
      ->check(one_of({"cone", "parallel"}))
      ->group(group);
  parser.add_option("--focus", words.focus, "From the tube's focus to the film (default: 400)")
      ->type_name("MM")
      ->check(positive)
      ->group(group);
  parser.add_option("--tube", words.tube, "Swing the tube to the right and upwards, degrees; the film stays")
      ->type_name("H,V")
      ->group(group);
  parser.add_option("--film", words.film, "Its size in mm (default: 31x41, or as large as the shadow needs)")
      ->type_name("WxH")
      ->group(group);
  parser.add_option("--pixel", words.pixel, "Side of a pixel in mm (default: 0.05)")
      ->type_name("MM")
      ->check(positive)
      ->group(group);
  parser.add_option("--exposure", words.exposure, "So many times the usual one: more is darker")
      ->type_name("F")
      ->check(CLI::Range(1e-3, 1e3).description(""))
      ->group(group);
  parser.add_flag("--inverted", words.inverted, "What is dense is dark")->group(group);
  repeatable(parser.add_option("--attenuation", words.attenuation,
                               "Of a structure, 1/mm or a tissue: crown=0.4, tooth=dentine; repeatable"))
      ->type_name("S=MU")
      ->group(group);
  add_grey_option(parser, words.grey);
}

void refuse_senseless(const RadiographWords& words) {
  if (!words.on && words.any())
    throw UsageError(
        "--kv, --beam, --focus, --tube, --film, --pixel, --exposure, --inverted and --attenuation are about a "
        "radiograph",
        "Ask for one: --radiograph");
  if (words.focus && words.beam == "parallel")
    throw UsageError("--focus: the rays of a parallel beam come from no focus", "Leave one out.");
  tube_from(words.tube);
  film_from(words.film);
  greys_from(words.grey);
  if (words.on) attenuations_from(words.attenuation, effective_energy_kev(words.kv));
}

void refuse_words_about_pictures(const SceneWords& scene, const VolumeLookWords& look) {
  const bool looks = !look.show.empty() || !look.cast.empty() || !look.transfer.empty() || !look.slopes.empty() ||
                     !scene.opacity.empty() || !scene.colour.empty() || !scene.section.empty() || !scene.cap.empty() ||
                     !scene.back_faces.empty() || !scene.background.empty() || !scene.overlays.empty() ||
                     scene.occlusion || scene.wire || scene.wall_depth || scene.wall_thickness;
  if (looks || !scene.scene_file.empty() || !scene.camera_file.empty() || scene.parallel || scene.zoom != 1)
    throw UsageError(
        "a radiograph shows shadows: of the options under Looking and Showing only --view and --hide are about it",
        "Leave the others out.");
}

void radiographs(const RadiographWords& words, const Shown& shown, const std::string& file, const RadiographPose& pose,
                 Session& session, const TakeFilm& take) {
  std::vector<SolidSurfaces> solids = solids_of(shown, file, pose.hidden);
  const double energy = effective_energy_kev(words.kv);
  choose_attenuation(solids, words, energy);
  Extent extent;
  glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  std::vector<std::string> coefficients;
  for (const SolidSurfaces& solid : solids) {
    coefficients.push_back(fmt::format("{} {}", solid.name, measured(solid.attenuation)));
    for (const SurfaceMesh* surface : solid.surfaces)
      for (const Point3& place : surface->points) {
        extent.places.push_back(vector(place));
        low = glm::min(low, extent.places.back());
        high = glm::max(high, extent.places.back());
      }
  }
  extent.centre = 0.5 * (low + high);
  session.console.say(fmt::format("Radiograph at {:g} kV, as of {:g} keV: attenuation per mm: {}", words.kv, energy,
                                  fmt::join(coefficients, ", ")));
  take_films(words, pose, extent, session, take, [&](const FilmView& view) {
    FilmMap sum{view.columns, view.rows,
                std::vector<double>(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows))};
    for (const SolidSurfaces& solid : solids) {
      const FilmMap inside = length_inside(solid.surfaces, view, session.progress());
      for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += solid.attenuation * inside.values[i];
    }
    return sum;
  });
}

void radiographs(const RadiographWords& words, const Volume& volume, const std::string& file,
                 const RadiographPose& pose, Session& session, const TakeFilm& take) {
  refuse_words_about_solids(words, pose);
  const auto told = greys_from(words.grey);
  if (!told && looks_like_labels(volume))
    throw UsageError(fmt::format("{} looks like a label map, whose values are no grey", file),
                     "Say with --label N what is solid, or with --grey AIR,DENTINE that they are grey.");
  const GreyAnchors values = told ? *told : grey_anchors(volume);
  const double energy = effective_energy_kev(words.kv), dentine = linear_attenuation(*tissue_called("dentine"), energy);
  session.console.say(fmt::format(
      "Radiograph at {:g} kV, as of {:g} keV: value {:.6g} is taken as air and {:.6g} as dentine, {} per mm{}",
      words.kv, energy, values.air, values.dentine, measured(dentine),
      told ? "" : " (the middle of either side of Otsu's threshold; --grey says otherwise)"));
  Extent extent;
  glm::dvec3 low(0), high(0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<std::size_t>(axis);
    low[axis] = vector(volume.origin)[axis] - 0.5 * volume.spacing[n];
    high[axis] = low[axis] + static_cast<double>(volume.size[n]) * volume.spacing[n];
  }
  extent.centre = 0.5 * (low + high);
  for (unsigned corner = 0; corner < 8; ++corner)
    extent.places.emplace_back(corner & 1u ? high.x : low.x, corner & 2u ? high.y : low.y,
                               corner & 4u ? high.z : low.z);
  take_films(words, pose, extent, session, take, [&](const FilmView& view) {
    FilmMap sum = sum_through(volume, values.air, view, session.progress());
    for (double& value : sum.values) value *= dentine / (values.dentine - values.air);
    return sum;
  });
}

void radiographs(const RadiographWords& words, const RadiographInput& input, const RadiographPose& pose,
                 Session& session, const TakeFilm& take) {
  const bool voxels = !input.file.empty() && looks_like_a_volume(input.file) && !input.volume.any_level();
  if (!voxels && !words.grey.empty())
    throw UsageError("--grey is about a radiograph through the voxels of a volume",
                     "Leave it out, or leave out --iso and --label.");
  if (voxels) return through_file(words, input, pose, session, take);
  radiographs(words, shown_from(input.file, input.volume, input.dt, session), input.file, pose, session, take);
}

}  // namespace odontoscope::app
