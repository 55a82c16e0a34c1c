#include "recon/output/report_json.h"

#include <algorithm>

#include "recon/delaunay/verdict.h"
#include "recon/formats/json_values.h"
#include "recon/mesh/tetra_report.h"
#include "recon/mesh/vector.h"
#include "recon/output/complex_groups.h"

namespace odontoscope {
namespace {

Json input_json(const ReconstructCounts& counts) {
  return {{"slices", counts.slices},
          {"contours", counts.contours},
          {"points", counts.points},
          {"steiner_points", counts.steiner_points}};
}

Json tetrahedra_json(const ReconstructCounts& counts, const std::vector<TetraReport>& reports) {
  double volume = 0, smallest = 0, largest = 0;
  std::size_t non_positive = 0;
  bool any = false;
  for (const TetraReport& report : reports) {
    if (report.tetrahedra == 0) continue;
    volume += report.volume;
    non_positive += report.non_positive;
    smallest = any ? std::min(smallest, report.smallest_dihedral_deg.min) : report.smallest_dihedral_deg.min;
    largest = any ? std::max(largest, report.largest_dihedral_deg.max) : report.largest_dihedral_deg.max;
    any = true;
  }
  return {{"kept", counts.kept},
          {"restored", counts.restored},
          {"lifted_points", counts.lifted_points},
          {"trimmed", counts.trimmed},
          {"isolated_regions", counts.isolated_regions},
          {"raised_slabs", counts.raised_slabs},
          {"constrained_slices", counts.constrained_slices},
          {"largest_sideways", counts.largest_sideways},
          {"non_positive", non_positive},
          {"volume", volume},
          {"dihedral_min_deg", smallest},
          {"dihedral_max_deg", largest}};
}

Json structures_json(const Reconstruction& reconstruction, const std::vector<TetraReport>& tetrahedra) {
  Json structures = Json::array();
  for (std::size_t i = 0; i < reconstruction.solids.size(); ++i) {
    const TetraReport& report = tetrahedra[i];
    structures.push_back({{"structure", reconstruction.solids[i].structure},
                          {"surface", quality_json(reconstruction.solids[i].report)},
                          {"tetrahedra",
                           {{"count", report.tetrahedra},
                            {"volume", report.volume},
                            {"smallest_dihedral_deg", json_of(report.smallest_dihedral_deg)},
                            {"largest_dihedral_deg", json_of(report.largest_dihedral_deg)},
                            {"radius_ratio", json_of(report.radius_ratio)},
                            {"radius_edge_ratio", json_of(report.radius_edge_ratio)}}}});
  }
  return structures;
}

Json links_json(const std::vector<MadeLink>& links) {
  Json list = Json::array();
  for (const MadeLink& made : links) {
    list.push_back({{"structure", made.link.structure},
                    {"slice", made.link.slice},
                    {"lower", made.link.lower},
                    {"upper", made.link.upper},
                    {"connect", made.link.connect},
                    {"criterion", name(made.criterion)}});
  }
  return list;
}

Json void_links_json(const std::vector<MadeVoidLink>& links) {
  const auto named = [](const std::optional<std::size_t>& contour) {
    return contour ? Json(*contour) : Json("outside");
  };
  Json list = Json::array();
  for (const MadeVoidLink& made : links) {
    if (!made.lower && !made.upper) continue;  // the outside is always joined
    list.push_back({{"structure", made.structure},
                    {"slice", made.slice},
                    {"lower", named(made.lower)},
                    {"upper", named(made.upper)},
                    {"criterion", name(made.criterion)}});
  }
  return list;
}

Json json_of(const Topology& topology) {
  return {{"pieces", topology.pieces},
          {"handles", topology.handles},
          {"bubbles", topology.bubbles},
          {"euler", topology.euler()}};
}

Json attention_json(const std::vector<Attention>& items) {
  Json list = Json::array();
  for (const Attention& item : items) {
    Json links = Json::array();
    for (const Link& link : item.links)
      links.push_back({{"structure", link.structure},
                       {"slice", link.slice},
                       {"lower", link.lower},
                       {"upper", link.upper},
                       {"connect", link.connect}});
    list.push_back({{"kind", name(item.kind)},
                    {"structure", item.structure},
                    {"slice", item.slice},
                    {"last_slice", item.last_slice},
                    {"z", {item.z_lower, item.z_upper}},
                    {"at", json_of(item.place)},
                    {"seen", item.seen},
                    {"expected", json_of(item.expected)},
                    {"found", json_of(item.found)},
                    {"remedy", item.remedy},
                    {"links", std::move(links)}});
  }
  return list;
}

Json changes_json(const std::vector<SlabChange>& changes) {
  Json list = Json::array();
  for (const SlabChange& change : changes) {
    list.push_back({{"kind", name(change.kind)},
                    {"structure", change.structure},
                    {"slice", change.slice},
                    {"z", {change.z_lower, change.z_upper}},
                    {"at", json_of(change.place)},
                    {"volume", change.volume}});
    if (change.kind == SlabChange::Kind::trimmed) list.back()["tetrahedra"] = change.count;
    if (change.kind == SlabChange::Kind::interpolated) list.back()["slices"] = change.count;
  }
  return list;
}

/// Slabs that are as their contours and links imply are counted; the others are listed.
Json topology_json(const std::vector<SlabTopology>& slabs) {
  std::size_t as_implied = 0, interpolated = 0;
  Json others = Json::array();
  for (const SlabTopology& slab : slabs) {
    as_implied += slab.as_implied();
    interpolated += slab.interpolated > 0;
    if (slab.as_implied()) continue;
    others.push_back({{"structure", slab.structure},
                      {"slice", slab.slice},
                      {"implied", json_of(slab.implied)},
                      {"found", json_of(slab.found)},
                      {"interpolated", slab.interpolated}});
  }
  return {{"slabs", slabs.size()},
          {"as_implied", as_implied},
          {"interpolated", interpolated},
          {"otherwise", std::move(others)}};
}

Json simplification_json(const std::vector<StructureSimplification>& simplifications) {
  Json list = Json::array();
  for (const StructureSimplification& one : simplifications) {
    list.push_back({{"structure", one.structure},
                    {"triangles_before", one.triangles_before},
                    {"triangles", one.triangles},
                    {"largest_distance", one.distance.largest()},
                    {"mean_distance", one.distance.mean()},
                    {"simplified_to_full", json_of(one.distance.a_to_b)},
                    {"full_to_simplified", json_of(one.distance.b_to_a)},
                    {"diagonal", one.diagonal},
                    {"self_intersections", one.self_intersections},
                    {"kept_vertices", one.kept_vertices}});
  }
  return list;
}

Json json_of(const ModelElements& elements) {
  Json materials = Json::array();
  for (const elements::MaterialElements& one : elements.materials) {
    materials.push_back({{"structure", one.structure},
                         {"count", one.shape.tetrahedra},
                         {"volume", one.shape.volume},
                         {"exact_volume", one.exact_volume},
                         {"elements_to_exact", json_of(one.distance.a_to_b)},
                         {"exact_to_elements", json_of(one.distance.b_to_a)}});
  }
  return {{"size", elements.size}, {"asked", elements.asked}, {"structures", std::move(materials)}};
}

Json json_of(const SimplificationAim& aim) {
  Json json{{"aim", aim.aim}, {"triangles", aim.triangles}, {"reached", aim.reached()}, {"restarts", aim.restarts}};
  if (!aim.reached()) {
    json["edges_held_by"] = {{"topology", aim.obstacles.topology},
                             {"self_intersection", aim.obstacles.cuts},
                             {"shape", aim.obstacles.shape}};
  }
  return json;
}

template <class Time>
Json seconds_json(const std::vector<Time>& times) {
  Json seconds = Json::object();
  for (const Time& time : times) seconds[time.stage] = seconds.value(time.stage, 0.0) + time.seconds;
  return seconds;
}

Json db_json(const DbReconstruction& made, const DbOptions& options) {
  Json splits = Json::array();
  for (const double z : options.grid.splits) splits.push_back(z);
  Json db{{"grid",
           {{"columns", made.grid.columns},
            {"rows", made.grid.rows},
            {"layers", made.grid.layers.size()},
            {"spacing_x", made.grid.dx},
            {"spacing_y", made.grid.dy},
            {"splits", std::move(splits)}}},
          {"field", name(options.field.kind)},
          {"cases", name(options.cases)}};
  if (!options.decimation) return db;
  Json structures = Json::array();
  for (const DbSurface& one : made.surfaces) {
    structures.push_back({{"structure", one.structure},
                          {"before", json_of(std::vector{&one.before})},
                          {"triangles", one.report.triangles},
                          {"error", one.decimation_error.value_or(0)}});
  }
  db["decimation"] = {{"library", decimation_library()},
                      {"aim", options.decimation->triangles ? Json(*options.decimation->triangles) : Json("max")},
                      {"structures", std::move(structures)}};
  return db;
}

double area_of(const LabelledComplex& complex, const ComplexGroup& group) {
  double area = 0;
  for (const std::uint32_t f : group.faces) {
    const auto& [a, b, c] = complex.interfaces[f].triangle;
    const Point3 p = complex.mesh.points[a], q = complex.mesh.points[b], r = complex.mesh.points[c];
    area += length(cross(q - p, r - p)) / 2;
  }
  return area;
}

Json partition_json(const Reconstruction& made) {
  const LabelledComplex& complex = *made.complex;
  Json borders = Json::array();
  for (const ComplexGroup& group : groups_of(complex)) {
    borders.push_back({{"name", group.name},
                       {"inner", complex.structures[group.inner - 1]},
                       {"outer", group.outer == void_label ? Json() : Json(complex.structures[group.outer - 1])},
                       {"triangles", group.faces.size()},
                       {"area", area_of(complex, group)}});
  }
  const PartitionCounts& counts = made.partition;
  return {{"points", complex.mesh.points.size()},
          {"tetrahedra", complex.mesh.tetrahedra.size()},
          {"borders", std::move(borders)},
          {"crossings", counts.crossings},
          {"corners_cut", counts.corners_cut},
          {"closed_gap", counts.closed_gap},
          {"raised_points", counts.raised_points},
          {"relabelled", counts.relabelled},
          {"patches", counts.patches},
          {"cut_slabs", counts.cut_slabs}};
}

}  // namespace

std::string report_json(const DbReconstruction& made, const DbOptions& options) {
  std::vector<const SurfaceReport*> surfaces;
  Json structures = Json::array();
  for (const DbSurface& one : made.surfaces) {
    surfaces.push_back(&one.report);
    structures.push_back({{"structure", one.structure}, {"surface", quality_json(one.report)}});
  }
  Json report;
  report["method"] = "db";
  report["input"] = {{"slices", made.slices}, {"contours", made.contours}, {"points", made.points}};
  report["db"] = db_json(made, options);
  report["surface"] = json_of(surfaces);
  report["structures"] = std::move(structures);
  report["resampling"] = {{"exact", false}, {"slices_checked", 0}};
  report["seconds"] = seconds_json(made.seconds);
  report["threads"] = made.threads;
  report["certified"] = made.certified;
  return text_of(report);
}

std::string report_json(const Reconstruction& reconstruction, const ReportOptions& options) {
  std::vector<TetraReport> tetrahedra;
  std::vector<const SurfaceReport*> surfaces;
  bool manifold = true;
  for (const Solid& solid : reconstruction.solids) {
    tetrahedra.push_back(inspect(solid.tetrahedra));
    surfaces.push_back(&solid.report);
    manifold = manifold && solid.report.closed_oriented_manifold();
  }
  Json report;
  report["input"] = input_json(reconstruction.counts);
  if (options.volume) {
    Json isos = Json::object();
    for (const auto& [structure, value] : options.volume->isos) isos[structure] = value;
    report["volume"] = {{"isos", std::move(isos)}, {"remarks", options.volume->remarks}};
    if (const auto& motion = options.volume->upright) {
      report["volume"]["upright"] = {
          {"matrix", motion->matrix()}, {"degrees", motion->degrees()}, {"as_given", options.volume->as_given}};
    }
  }
  report["tetrahedra"] = tetrahedra_json(reconstruction.counts, tetrahedra);
  report["surface"] = json_of(surfaces);
  report["structures"] = structures_json(reconstruction, tetrahedra);
  // The engine proves the section of every slice that it counts here, or returns nothing.
  report["resampling"] = {{"exact", reconstruction.certified}, {"slices_checked", reconstruction.slices_checked}};
  if (reconstruction.complex) report["partition"] = partition_json(reconstruction);
  report["links"] = links_json(reconstruction.links);
  report["void_links"] = void_links_json(reconstruction.void_links);
  report["topology"] = topology_json(reconstruction.topology);
  report["changes"] = changes_json(reconstruction.changes);
  report["attention"] = attention_json(reconstruction.attention);
  report["cut_links"] = reconstruction.counts.cut_links;
  if (options.aim) report["simplification_aim"] = json_of(*options.aim);
  if (!options.simplifications.empty()) report["simplification"] = simplification_json(options.simplifications);
  if (options.elements) report["elements"] = json_of(*options.elements);
  report["seconds"] = seconds_json(reconstruction.seconds);
  report["threads"] = reconstruction.threads;
  report["certified"] = reconstruction.certified && manifold;
  report["verdict"] = name(verdict_of(reconstruction));
  return text_of(report);
}

std::string surface_report_json(const std::string& file, const std::vector<NamedSurfaceReport>& meshes) {
  std::vector<const SurfaceReport*> all;
  bool manifold = !meshes.empty();
  Json list = Json::array();
  for (const NamedSurfaceReport& mesh : meshes) {
    all.push_back(&mesh.report);
    manifold = manifold && mesh.report.closed_oriented_manifold();
    Json entry{{"name", mesh.name}, {"closed_oriented_manifold", mesh.report.closed_oriented_manifold()}};
    entry.update(json_of(std::vector{&mesh.report}));
    entry.update(quality_json(mesh.report));
    list.push_back(std::move(entry));
  }
  return text_of({{"file", file}, {"closed_oriented_manifold", manifold}, {"surface", json_of(all)}, {"meshes", list}});
}

}  // namespace odontoscope
