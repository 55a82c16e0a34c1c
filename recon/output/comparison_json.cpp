#include "recon/output/comparison_json.h"

#include "recon/formats/json_values.h"

namespace odontoscope {
namespace {

Json json_of(const PassageCounts& counts) {
  return {{"all", counts.all},
          {"lost", counts.lost},
          {"thinnest_kept", counts.thinnest_kept > 0 ? Json(counts.thinnest_kept) : Json()},
          {"widest_lost", counts.widest_lost > 0 ? Json(counts.widest_lost) : Json()}};
}

Json json_of(const ComparedMethod& method) {
  Json json{{"name", method.name}, {"made_by", method.made_by}, {"certified", method.certified}};
  if (!method.verdict.empty()) json["verdict"] = method.verdict;
  json["topology"] = {{"as_implied", method.topology.as_implied}, {"known", method.topology.known}};
  json["surface"] = json_of(std::vector{&method.report});
  json.update(quality_json(method.report));
  json["contours_to_surface"] = json_of(method.fit.contours_to_surface);
  json["section_to_contours"] = json_of(method.fit.section_to_contours);
  json["holes"] = json_of(method.fit.holes);
  json["solid_sections"] = json_of(method.fit.solids);
  if (method.seen_through)
    json["seen_through"] = {{"cameras", method.seen_through->cameras},
                            {"culled", method.seen_through->culled},
                            {"two_sided", method.seen_through->two_sided}};
  json["seconds"] = method.seconds;
  json["peak_memory_bytes"] = method.peak_memory ? Json(*method.peak_memory) : Json();
  return json;
}

Json json_of(const CanalResult& result, std::size_t slices) {
  Json json = Json::object();
  if (result.grid > 0) json["grid"] = result.grid;
  json["open_through"] = result.open_through;
  json["open_slices"] = result.open_slices;
  json["slices"] = slices;
  json["surfaces"] = result.surfaces;
  json["genus"] = result.genus;
  json["triangles"] = result.triangles;
  return json;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json report;
  report["source"] = comparison.source;
  report["input"] = {{"slices", comparison.slices}, {"contours", comparison.contours}, {"points", comparison.points}};
  report["grid"] = {{"columns", comparison.grid.columns},
                    {"rows", comparison.grid.rows},
                    {"layers", comparison.grid.layers.size()},
                    {"spacing_x", comparison.grid.dx},
                    {"spacing_y", comparison.grid.dy}};
  report["cases"] = name(comparison.cases);
  report["field"] = name(comparison.field);
  report["methods"] = Json::array();
  for (const ComparedMethod& method : comparison.methods) report["methods"].push_back(json_of(method));
  report["distances"] = Json::array();
  for (const ComparedPair& pair : comparison.pairs) {
    report["distances"].push_back({{"from", comparison.methods[pair.first].name},
                                   {"to", comparison.methods[pair.second].name},
                                   {"there", json_of(pair.distance.a_to_b)},
                                   {"back", json_of(pair.distance.b_to_a)}});
  }
  report["threads"] = comparison.threads;
  return text_of(report);
}

std::string canal_json(const CanalExperiment& experiment) {
  Json report;
  report["canal_mm"] = experiment.tooth.canal;
  report["cases"] = name(experiment.cases);
  report["dt"] = json_of(experiment.dt, experiment.slices);
  report["db"] = Json::array();
  for (const CanalResult& result : experiment.db) report["db"].push_back(json_of(result, experiment.slices));
  return text_of(report);
}

}  // namespace odontoscope
