#include "engine/app/model_page.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "engine/app/volume_look_words.h"
#include "engine/app/whole_structures.h"
#include "engine/language/language.h"
#include "engine/navigate/tour_camera_path.h"
#include "engine/scene/shells.h"
#include "recon/cavity/canal_names.h"
#include "recon/cavity/centre_lines.h"
#include "recon/cavity/tooth_axis.h"
#include "recon/core/error.h"
#include "recon/formats/write_glb.h"
#include "recon/radiograph/tissue.h"
#include "recon/sample/tooth_number.h"

namespace odontoscope::app {
namespace {

const char* name(Certificate::Verdict verdict) {
  switch (verdict) {
    case Certificate::Verdict::certified:
      return "certified";
    case Certificate::Verdict::look_here:
      return "amber";
    case Certificate::Verdict::sound:
      return "sound";
    case Certificate::Verdict::wanting:
      break;
  }
  return "wanting";
}

const char* name(Certificate::Mark mark) {
  switch (mark) {
    case Certificate::Mark::good:
      return "good";
    case Certificate::Mark::look:
      return "look";
    case Certificate::Mark::bad:
      break;
  }
  return "bad";
}

WebCertificate in_web_words(const Certificate& certificate) {
  WebCertificate web;
  web.verdict = name(certificate.verdict);
  web.headline = certificate.headline;
  for (const Certificate::Finding& finding : certificate.findings) {
    web.findings.push_back({name(finding.mark), finding.words, {}});
    if (finding.at) web.findings.back().at_mm = Point3{finding.at->x, finding.at->y, finding.at->z};
  }
  return web;
}

std::optional<double> attenuation_of(const std::string& structure) {
  const auto tissue = tissue_called(structure);
  return tissue ? std::optional(linear_attenuation(*tissue, effective_energy_kev(usual_kv))) : std::nullopt;
}

WebTour along(const CentreLine& line) {
  WebTour tour{line.name, {}, line.length_to_wall()};
  for (const CentrePoint& point : line.points) tour.points.push_back(point.at);
  return tour;
}

}  // namespace

WebModel web_model(const WrittenModel& written, const Certificate& certificate) {
  WebModel model;
  for (const WrittenSurface& one : written.solids) model.triangles += one.surface.triangles.size();
  model.glb = glb_bytes(written);
  model.certificate = in_web_words(certificate);
  return model;
}

std::vector<NamedSurface> surfaces_of(const WrittenModel& written) {
  std::vector<NamedSurface> surfaces;
  for (const WrittenSurface& one : written.solids) {
    const std::size_t before = surfaces.size();
    add_shells(one.structure, one.surface, one.report, surfaces);
    if (surfaces.size() == before + 1 && surfaces.back().surface.triangles.empty())
      surfaces.back().surface = one.surface;  // all open
  }
  return surfaces;
}

Scene usual_scene_of(const WrittenModel& written) {
  return usual_scene(odontoscope::make_model(surfaces_of(written)), 1);
}

std::vector<WebLook> looks_of(const Scene& scene) {
  std::vector<WebLook> looks;
  for (const Look& look : scene.looks)
    looks.push_back({look.structure, hex(look.colour), look.opacity, look.as_body,
                     depth_in_tooth(look.structure).value_or(1), attenuation_of(look.structure)});
  return looks;
}

void add_ways(const WrittenModel& written, WebPage& page, const Progress& progress) {
  const std::vector<Cavity> cavities = cavities_in(sound_structures(written));
  if (cavities.empty()) return;
  try {
    const CentreLines lines = centre_lines(cavities.front(), {tooth_axis(sound_structures(written)).along}, progress);
    for (const CentreLine& canal : lines.canals) {
      page.tours.push_back(along(canal));
      // As the program flies it; its far plane is the page's own.
      if (canal.points.size() > 1) page.tours.back().keys = camera_path(Tour(canal), canal.name, 0).keys;
      if (canal.orifice > 0 || !lines.has_chamber) page.tours.back().orifice_mm = canal.points[canal.orifice].along;
    }
    for (const CentreLine& horn : lines.horns) page.horns.push_back(along(horn));
    if (const auto kind = sample_of(lines)) page.tooth = tooth_in_words(*kind);
  } catch (const UsageError&) {  // the page is of use without them
  }
}

WebModel web_model_by_dt(const Reconstruction& made, bool simplified, const std::vector<std::string>& warnings) {
  Certificate certificate = certificate_of(proven_by(made));
  for (const std::string& warning : warnings) certificate.findings.push_back({Certificate::Mark::bad, warning + "."});
  if (simplified)
    certificate.findings.push_back(
        {Certificate::Mark::good,
         "The surfaces were simplified; what is said of slices and tetrahedra is true of the full model."});
  WebModel model = web_model(made, certificate);
  model.name = "DT";
  model.words =
      "Delaunay: a solid of tetrahedra between neighbouring slices, whose surface is proven to be closed and to face "
      "outwards.";
  return model;
}

std::string language_in_page(const std::string& asked) {
  if (asked.empty()) return {};
  Language language = language_asked(asked);
  language.errors.clear();  // the page reads no files
  return knows_language(asked) ? fmt::format(R"({{"language":"{}"}})", language.tag) : to_json(language);
}

WebModel web_model_by_db(const DbReconstruction& made, CaseTable cases) {
  std::vector<std::string> structures;
  std::vector<SurfaceReport> reports;
  for (const DbSurface& one : made.surfaces) {
    structures.push_back(one.structure);
    reports.push_back(one.report);
  }
  WebModel model = web_model(made, certificate_of(structures, reports));
  model.name = "DB";
  model.words = fmt::format(
      "Distance field and marching cubes: a grid of {} x {} points in {} layers, table {}. Cracks and wrongly turned "
      "triangles are the method's own.",
      made.grid.columns, made.grid.rows, made.grid.layers.size(), name(cases));
  return model;
}

}  // namespace odontoscope::app
