#include "engine/app/web_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <utility>

#include "engine/app/certificate.h"
#include "engine/app/foreign_input.h"
#include "engine/app/model.h"
#include "engine/app/shown_values.h"
#include "engine/app/sniff.h"
#include "engine/app/web_volume.h"
#include "engine/app/whole_structures.h"
#include "engine/scene/scene.h"
#include "engine/scene/shells.h"
#include "recon/cavity/centre_lines.h"
#include "recon/cavity/tooth_axis.h"
#include "recon/core/read_file.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/mesh/append.h"
#include "recon/mesh/read_mesh.h"
#include "recon/output/write_glb.h"
#include "recon/radiograph/tissue.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::app {
namespace {

/// A structure's whole surface with what is known of it.
struct Inspected {
  std::string structure;
  SurfaceMesh surface;
  SurfaceReport report;
};

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

WebModel web_model(const WrittenModel& written, const Certificate& certificate) {
  WebModel model;
  for (const WrittenSurface& one : written.solids) model.triangles += one.surface.triangles.size();
  model.glb = glb_bytes(written);
  model.certificate = in_web_words(certificate);
  return model;
}

/// The desktop's first look at the same surfaces.
Scene usual_scene_of(const WrittenModel& written) {
  std::vector<NamedSurface> surfaces;
  for (const WrittenSurface& one : written.solids) {
    const std::size_t before = surfaces.size();
    add_shells(one.structure, one.surface, one.report, surfaces);
    if (surfaces.size() == before + 1 && surfaces.back().surface.triangles.empty()) surfaces.back().surface = one.surface;   // all open
  }
  return usual_scene(odontoscope::make_model(surfaces), 1);
}

std::optional<double> attenuation_of(const std::string& structure) {
  constexpr double kv = 70;
  const auto tissue = tissue_called(structure);
  return tissue ? std::optional(linear_attenuation(*tissue, effective_energy_kev(kv))) : std::nullopt;
}

std::vector<WebLook> looks_of(const Scene& scene) {
  std::vector<WebLook> looks;
  for (const Look& look : scene.looks)
    looks.push_back({look.structure, hex(look.colour), look.opacity, look.as_body, depth_in_tooth(look.structure).value_or(1), attenuation_of(look.structure)});
  return looks;
}

WebTour along(const CentreLine& line) {
  WebTour tour{line.name, {}, line.length_to_wall()};
  for (const CentrePoint& point : line.points) tour.points.push_back(point.at);
  return tour;
}

/// The centre lines of the largest void's canals and horns, from the chamber to their ends; none where the void's wall is not sound enough for any.
void add_ways(const WrittenModel& written, WebPage& page, Session& session) {
  const std::vector<Cavity> cavities = cavities_in(sound_structures(written));
  if (cavities.empty()) return;
  try {
    const CentreLines lines = centre_lines(cavities.front(), {tooth_axis(sound_structures(written)).along}, session.progress());
    for (const CentreLine& canal : lines.canals) {
      page.tours.push_back(along(canal));
      if (canal.orifice > 0 || !lines.has_chamber) page.tours.back().orifice_mm = canal.points[canal.orifice].along;
    }
    for (const CentreLine& horn : lines.horns) page.horns.push_back(along(horn));
  } catch (const UsageError&) {   // the page is of use without them
  }
}

/// What a page carries of the volume that its model was made from.
struct Greys {
  std::shared_ptr<const ValueGrid> values;
  GreyAnchors anchors;
  std::vector<double> isos;
};

void add_volume(const Greys& greys, const WebWords& words, Scene& scene, WebPage& page, Session& session) {
  Shown shown;
  shown.values = greys.values;
  shown.greys = greys.anchors;
  constexpr double kv = 70;
  show_volume({words.look, words.grey, kv, {}, false}, shown, scene, session);
  page.volume = web_volume(*greys.values, greys_from(words.grey).value_or(greys.anchors), scene.volume);
  page.volume->isos = greys.isos;
  tell_web_volume(*page.volume, *greys.values, session);
}

WebModel model_by_dt(const ContourStack& stack, const std::optional<Greys>& greys, const WebWords& words, WebPage& page, Session& session) {
  Model made{reconstructed(stack, words.dt, session), {}, {}};
  add_ways(made.reconstruction, page, session);
  Scene scene = usual_scene_of(made.reconstruction);   // of the full surfaces: simplified ones lie less exactly within each other
  if (greys) add_volume(*greys, words, scene, page, session);
  page.looks = looks_of(scene);
  if (words.triangles) simplify_model(made, static_cast<std::size_t>(*words.triangles), session.progress());
  session.progress().check();
  session.progress().tell("page", 0.2);
  Certificate certificate = certificate_of(proven_by(made.reconstruction));
  for (const std::string& warning : {made.aim ? missed_aim_in_words(*made.aim) : "", absurd_distance_in_words(made.simplifications)}) {
    if (warning.empty()) continue;
    session.console.complain("warning: " + warning + ".");
    certificate.findings.push_back({Certificate::Mark::bad, warning + "."});
  }
  if (!made.simplifications.empty())
    certificate.findings.push_back(
        {Certificate::Mark::good,
         "The surfaces were simplified; what is said of slices and tetrahedra is true of the full model."});
  WebModel model = web_model(made.reconstruction, certificate);
  model.name = "DT";
  model.words = "Delaunay: a solid of tetrahedra between neighbouring slices, whose surface is proven to be closed and to face outwards.";
  return model;
}

WebModel model_by_db(const ContourStack& stack, const DbWords& words, Session& session) {
  const DbReconstruction made = reconstruct_by_distance(stack, understood(words, session.threads), session.progress());
  std::vector<std::string> structures;
  std::vector<SurfaceReport> reports;
  for (const DbSurface& one : made.surfaces) {
    structures.push_back(one.structure);
    reports.push_back(one.report);
  }
  WebModel model = web_model(made, certificate_of(structures, reports));
  model.name = "DB";
  model.words = fmt::format("Distance field and marching cubes: a grid of {} x {} points in {} layers, table {}. Cracks and wrongly turned triangles are the method's own.",
                            made.grid.columns, made.grid.rows, made.grid.layers.size(), name(words.cases.value_or(DbOptions{}.cases)));
  return model;
}

std::vector<Inspected> inspected(const std::vector<NamedMesh>& meshes, const std::string& file, Session& session) {
  std::vector<Inspected> solids;
  for (const NamedMesh& mesh : meshes) {
    const std::string structure = mesh.name.empty() ? std::filesystem::path(file).stem().string() : structure_of_mesh(mesh.name);
    auto known = std::find_if(solids.begin(), solids.end(), [&](const Inspected& solid) { return solid.structure == structure; });
    if (known == solids.end()) known = solids.insert(known, {structure, {}, {}});
    append(mesh.surface, known->surface);
  }
  for (Inspected& solid : solids) {
    session.progress().check();
    solid.report = inspect(solid.surface);
  }
  return solids;
}

WebPage page_of_meshes(const std::vector<NamedMesh>& meshes, const std::string& file, Session& session) {
  const std::vector<Inspected> solids = inspected(meshes, file, session);
  WrittenModel written;
  std::vector<std::string> structures;
  std::vector<SurfaceReport> reports;
  for (const Inspected& solid : solids) {
    written.solids.push_back({solid.structure, solid.surface, solid.report});
    structures.push_back(solid.structure);
    reports.push_back(solid.report);
  }
  WebPage page;
  page.looks = looks_of(usual_scene_of(written));
  add_ways(written, page, session);
  page.models.push_back(web_model(written, certificate_of(structures, reports)));
  page.models.back().name = "Mesh";
  page.models.back().words = "A mesh, as it was read.";
  return page;
}

std::optional<std::vector<NamedMesh>> meshes_of(const WebWords& words, Session& session) {
  if (words.input.empty() || words.volume.any_level()) return {};
  if (words.with_volume()) throw UsageError("--show volume and --show both are about the grey values of a volume", "Name the volume that the model was made from, with --iso.");
  const std::string bytes = read_file(words.input, limits::file_bytes, session.progress().stop);
  return meshes_in(kind_of(bytes, words.input), bytes, words.input);
}

/// The contours of a volume, and what lies around them.
ContourStack stack_with_greys(const WebWords& words, std::optional<Greys>& greys, Session& session) {
  Volume volume;
  std::optional<ReportVolume> facts;
  ContourStack stack = contours_told(words.input, understood(words.volume), session, &volume, &facts);
  greys.emplace();
  greys->anchors = grey_anchors(volume);
  greys->values = std::make_shared<const ValueGrid>(value_grid(volume, with_margin(bounds_of(stack), volume), page_values));
  for (const auto& [structure, iso] : facts->isos) greys->isos.push_back(iso);
  return stack;
}

/// Of ours, of another program's contour file, or of a volume.
ContourStack stack_of(const WebWords& words, std::optional<Greys>& greys, Session& session) {
  if (words.with_volume()) return stack_with_greys(words, greys, session);
  if (words.input.empty()) return sample_tooth(ToothKind::molar);
  if (words.volume.any_level() || !needs_conversion(words.input, {})) return contours_of_input(words.input, words.volume, session);
  ContourStack stack = converted_told(words.input, {}, session);
  return words.volume.simplify ? simplify_told(stack, {*words.volume.simplify}, session) : stack;
}

}  // namespace

void refuse_senseless(const WebWords& words) {
  if (words.db.any() && !words.with_db) throw UsageError("--grid, --cases, --field, --split and --decimate are about the DB method", "Add --db");
  refuse_senseless(words.look);
  greys_from(words.grey);
  if (!words.with_volume() && !(words.look.cast + words.look.transfer + words.grey).empty())
    throw UsageError("--cast, --transfer and --grey are about a volume's grey values", "Put them into the page: --show volume, or --show both.");
  if (words.with_volume() && words.input.empty()) throw UsageError("only a volume has grey values to show", "Name one, with --show volume, or with --iso and --show both.");
  if (words.alone()) {
    if (words.look.show == "both") throw UsageError("--show both: nothing says where in the volume the surface lies", "Give --iso T (or --iso auto) for an image, or --show volume.");
    if (words.with_db || words.triangles) throw UsageError("--db and --triangles are about surfaces, and nothing says where in the volume they lie", "Give --iso T, or leave them out.");
  } else refuse_volume_without_level(words.input, words.volume);
  if (words.input.empty() && words.volume.any_level()) throw UsageError("--iso and --label want a volume", "Name it before the options");
  understood(words.db, 1);
  refuse_senseless(words.dt);
  if (words.volume.any_level()) understood(words.volume);
}

bool WebWords::alone() const { return with_volume() && !volume.any_level() && named_like_a_volume(input); }

WebPage web_page_of(const WebWords& words, Session& session) {
  if (words.alone()) {
    refuse_for_mesh(words.dt, words.input);
    return page_of_voxels(words.input, words.volume, words.look, words.grey, session);
  }
  if (const auto meshes = meshes_of(words, session)) {
    refuse_for_mesh(words.dt, words.input);
    if (words.with_db || words.triangles)
      throw UsageError(fmt::format("{} is a mesh; --db and --triangles want contours or a volume", words.input), "Leave them out, or give what the mesh was made from");
    return page_of_meshes(*meshes, words.input, session);
  }
  std::optional<Greys> greys;
  const ContourStack stack = stack_of(words, greys, session);
  WebPage page;
  page.models.push_back(model_by_dt(stack, greys, words, page, session));
  if (words.with_db) page.models.push_back(model_by_db(stack, words.db, session));
  return page;
}

}  // namespace odontoscope::app
