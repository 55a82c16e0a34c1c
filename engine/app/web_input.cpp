#include "engine/app/web_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <utility>

#include "engine/app/certificate_text.h"
#include "engine/app/foreign_input.h"
#include "engine/app/made_model.h"
#include "engine/app/model_page.h"
#include "engine/app/shown_values.h"
#include "engine/app/sniff.h"
#include "engine/app/web_volume.h"
#include "engine/scene/scene.h"
#include "recon/core/read_file.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/formats/read_mesh.h"
#include "recon/mesh/append.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::app {
namespace {

/// A structure's whole surface with what is known of it.
struct Inspected {
  std::string structure;
  SurfaceMesh surface;
  SurfaceReport report;
};

/// What a page's model is made from.
struct Contoured {
  ValidStack stack;
  std::optional<PageGreys> greys;     // if the page carries them
  std::optional<ReportVolume> facts;  // of the volume that it came from
};

WebModel model_by_dt(const Contoured& from, const WebWords& words, WebPage& page, Session& session) {
  Model made{reconstructed(from.stack, words.dt, session), {}, {}, {}};
  add_ways(made.reconstruction, page, session.progress());
  Scene scene =
      usual_scene_of(made.reconstruction);  // of the full surfaces: simplified ones lie less exactly within each other
  if (from.greys) add_greys(*from.greys, words.look, words.grey, scene, page, session);
  page.looks = looks_of(scene);
  if (words.triangles) simplify_model(made, static_cast<std::size_t>(*words.triangles), session.progress());
  session.progress().check();
  session.progress().tell("page", 0.2);
  std::vector<std::string> warnings;
  for (std::string& warning :
       std::array{made.aim ? missed_aim_in_words(*made.aim) : "", absurd_distance_in_words(made.simplifications)}) {
    if (warning.empty()) continue;
    session.console.complain("warning: " + warning + ".");
    warnings.push_back(std::move(warning));
  }
  WebModel model = web_model_by_dt(made.reconstruction, !made.simplifications.empty(), warnings);
  if (session.keep) session.keep({std::move(made), from.facts});
  return model;
}

WebModel model_by_db(const ValidStack& stack, const DbWords& words, Session& session) {
  return web_model_by_db(reconstruct_by_distance(stack, understood(words, session.threads), session.progress()),
                         words.cases.value_or(DbOptions{}.cases));
}

std::vector<Inspected> inspected(const std::vector<NamedMesh>& meshes, const std::string& file, Session& session) {
  std::vector<Inspected> solids;
  for (const NamedMesh& mesh : meshes) {
    const std::string structure =
        mesh.name.empty() ? std::filesystem::path(file).stem().string() : structure_of_mesh(mesh.name);
    auto known = std::find_if(solids.begin(), solids.end(),
                              [&](const Inspected& solid) { return solid.structure == structure; });
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
  page.looks = looks_of(written);
  add_ways(written, page, session.progress());
  page.models.push_back(web_model(written, certificate_of(structures, reports)));
  page.models.back().name = "Mesh";
  page.models.back().words = "A mesh, as it was read.";
  return page;
}

std::optional<std::vector<NamedMesh>> meshes_of(const WebWords& words, Session& session) {
  if (words.input.empty() || words.volume.any_level()) return {};
  if (words.with_volume())
    throw UsageError("--show volume and --show both are about the grey values of a volume",
                     "Name the volume that the model was made from, with --iso.");
  const std::string bytes = read_file(words.input, limits::file_bytes, session.progress().stop);
  return meshes_in(kind_of(bytes, words.input), bytes, words.input);
}

/// The contours of a volume, and what lies around them.
Contoured contoured_with_greys(const WebWords& words, Session& session) {
  Volume volume;
  std::optional<ReportVolume> facts;
  const ValidStack stack =
      validate(contours_told(words.input, understood(words.volume), session, &volume, &facts), session.progress());
  PageGreys greys = page_greys(volume, stack, *facts);
  return {stack, std::move(greys), std::move(facts)};
}

/// Of ours, of another program's contour file, or of a volume.
Contoured contoured(const WebWords& words, Session& session) {
  if (words.with_volume()) return contoured_with_greys(words, session);
  if (words.input.empty()) return {validate(sample_tooth(ToothKind::molar), session.progress()), {}, {}};
  if (words.volume.any_level() || !needs_conversion(words.input, {})) {
    std::optional<ReportVolume> facts;
    const ValidStack stack = contours_of_input(words.input, words.volume, session, &facts);
    return {stack, {}, std::move(facts)};
  }
  const ValidStack stack = converted_told(words.input, {}, session);
  if (!words.volume.simplify) return {stack, {}, {}};
  return {validate(simplify_told(stack, {*words.volume.simplify}, session), session.progress()), {}, {}};
}

}  // namespace

void refuse_senseless(const WebWords& words) {
  if (words.db.any() && !words.with_db)
    throw UsageError("--grid, --cases, --field, --split and --decimate are about the DB method", "Add --db");
  refuse_senseless(words.look);
  greys_from(words.grey);
  if (!words.with_volume() && (words.look.any_of_volume() || !words.grey.empty()))
    throw UsageError("--cast, --transfer and --grey are about a volume's grey values",
                     "Put them into the page: --show volume, or --show both.");
  if (words.with_volume() && words.input.empty())
    throw UsageError("only a volume has grey values to show",
                     "Name one, with --show volume, or with --iso and --show both.");
  if (words.alone()) {
    if (words.look.show == "both")
      throw UsageError("--show both: nothing says where in the volume the surface lies",
                       "Give --iso T (or --iso auto) for an image, or --show volume.");
    if (words.with_db || words.triangles)
      throw UsageError("--db and --triangles are about surfaces, and nothing says where in the volume they lie",
                       "Give --iso T, or leave them out.");
  } else
    refuse_volume_without_level(words.input, words.volume);
  if (words.input.empty() && words.volume.any_level())
    throw UsageError("--iso and --label want a volume", "Name it before the options");
  understood(words.db, 1);
  refuse_senseless(words.dt);
  if (words.volume.any_level()) understood(words.volume);
}

bool WebWords::alone() const { return with_volume() && !volume.any_level() && looks_like_a_volume(input); }

WebPage web_page_of(const WebWords& words, Session& session) {
  if (words.alone()) {
    refuse_for_mesh(words.dt, words.input);
    return page_of_voxels(voxels_alone(words.input, words.volume, page_values, session), words.look, words.grey,
                          session);
  }
  if (const auto meshes = meshes_of(words, session)) {
    refuse_for_mesh(words.dt, words.input);
    if (words.with_db || words.triangles)
      throw UsageError(fmt::format("{} is a mesh; --db and --triangles want contours or a volume", words.input),
                       "Leave them out, or give what the mesh was made from");
    return page_of_meshes(*meshes, words.input, session);
  }
  const Contoured from = contoured(words, session);
  WebPage page;
  page.models.push_back(model_by_dt(from, words, page, session));
  if (words.with_db) page.models.push_back(model_by_db(from.stack, words.db, session));
  return page;
}

}  // namespace odontoscope::app
