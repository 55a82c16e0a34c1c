#include "recon/formats/json_values.h"

namespace odontoscope {

const char* name(Shell::Kind kind) {
  switch (kind) {
    case Shell::Kind::external:
      return "external";
    case Shell::Kind::cavity:
      return "cavity";
    case Shell::Kind::open:
      return "open";
  }
  return "open";
}

Json json_of(const Point3& place) { return {place.x, place.y, place.z}; }

Json json_of(const OneWayDistance& distance) { return {{"largest", distance.largest}, {"mean", distance.mean}}; }

Json json_of(const Distribution& distribution) {
  return {{"min", distribution.min},
          {"median", distribution.median},
          {"mean", distribution.mean},
          {"max", distribution.max},
          {"histogram", distribution.histogram},
          {"histogram_low", distribution.histogram_low},
          {"histogram_high", distribution.histogram_high}};
}

Json json_of(const std::vector<const SurfaceReport*>& reports) {
  SurfaceReport sum;
  Json shells = Json::array();
  for (const SurfaceReport* report : reports) {
    sum.vertices += report->vertices;
    sum.triangles += report->triangles;
    sum.boundary_edges += report->boundary_edges;
    sum.nonmanifold_edges += report->nonmanifold_edges;
    sum.misoriented_edges += report->misoriented_edges;
    sum.nonmanifold_vertices += report->nonmanifold_vertices;
    sum.degenerate_triangles += report->degenerate_triangles;
    for (const Shell& shell : report->shells) {
      shells.push_back({{"kind", name(shell.kind)},
                        {"structure", shell.structure},
                        {"triangles", shell.triangles},
                        {"vertices", shell.vertices},
                        {"genus", shell.kind == Shell::Kind::open ? Json() : Json(shell.genus)},
                        {"volume", shell.volume},
                        {"area", shell.area}});
    }
  }
  return {{"vertices", sum.vertices},
          {"triangles", sum.triangles},
          {"boundary_edges", sum.boundary_edges},
          {"nonmanifold_edges", sum.nonmanifold_edges},
          {"misoriented_edges", sum.misoriented_edges},
          {"nonmanifold_vertices", sum.nonmanifold_vertices},
          {"degenerate_triangles", sum.degenerate_triangles},
          {"shells", std::move(shells)}};
}

Json quality_json(const SurfaceReport& report) {
  return {{"smallest_angle_deg", json_of(report.smallest_angle_deg)}, {"aspect_ratio", json_of(report.aspect_ratio)}};
}

std::string text_of(const Json& json) {
  constexpr int indent = 2;
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace odontoscope
