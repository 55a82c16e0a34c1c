#include "tests/support/oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "tests/support/joined.h"
#include "tests/support/oracle_parts.h"
#include "tests/support/oracle_topology.h"
#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

std::string kind_name(Shell::Kind kind) {
  return kind == Shell::Kind::external ? "external" : kind == Shell::Kind::cavity ? "cavity" : "open";
}

void judge_report(const Solid& solid, const Verdict& verdict, Faults& faults) {
  std::vector<std::pair<Shell::Kind, long>> told, found;
  for (const Shell& shell : solid.report.shells) {
    told.emplace_back(shell.kind, shell.genus);
    if (shell.structure != solid.structure) faults.add("a shell without its structure's name", shell.structure);
  }
  for (const JudgedShell& shell : verdict.shells) found.emplace_back(shell.kind, shell.genus);
  std::sort(told.begin(), told.end());
  std::sort(found.begin(), found.end());
  if (told != found) faults.add("the report's shells are not those of the surface");
  if (solid.report.triangles != solid.surface.triangles.size()) faults.add("the report's number of triangles is wrong");
  if (!solid.report.closed_oriented_manifold()) faults.add("the report denies that the surface is a manifold");
}

struct Region {
  std::size_t slice, contour;
  std::size_t component;  // of the solid
};

std::vector<Region> regions_of(const Solid& solid, const Verdict& verdict, const ContourStack& sorted) {
  std::map<std::array<double, 3>, std::size_t> component_at;
  for (std::size_t i = 0; i < solid.tetrahedra.points.size(); ++i) {
    const Point3 p = solid.tetrahedra.points[i];
    component_at[{p.x, p.y, p.z}] = verdict.component_of[i];
  }
  std::vector<Region> regions;
  for (std::size_t k = 0; k < sorted.slices.size(); ++k) {
    const Slice& slice = sorted.slices[k];
    std::vector<std::vector<Point2>> rings;
    std::vector<std::size_t> numbers;
    for (std::size_t c = 0; c < slice.contours.size(); ++c)
      if (slice.contours[c].structure == solid.structure) {
        rings.push_back(slice.contours[c].points);
        numbers.push_back(c);
      }
    for (std::size_t r = 0; r < rings.size(); ++r)
      if (depth_of(rings, r) % 2 == 0) {
        const auto at = component_at.find({rings[r][0].x, rings[r][0].y, slice.z});
        if (at != component_at.end()) regions.push_back({k, numbers[r], at->second});
      }
  }
  return regions;
}

/// Two regions are in one piece of the solid exactly if a chain of links joins them.
void judge_links(const Solid& solid, const Verdict& verdict, const std::vector<MadeLink>& links,
                 const ContourStack& sorted, Faults& faults) {
  const std::vector<Region> regions = regions_of(solid, verdict, sorted);
  const auto number = [&](std::size_t slice, std::size_t contour) {
    return std::size_t(std::find_if(regions.begin(), regions.end(),
                                    [&](const Region& r) { return r.slice == slice && r.contour == contour; }) -
                       regions.begin());
  };
  Joined joined(regions.size());
  for (const MadeLink& made : links) {
    if (made.link.structure != solid.structure) continue;
    const std::size_t a = number(made.link.slice, made.link.lower), b = number(made.link.slice + 1, made.link.upper);
    if (!made.link.connect) faults.add("a link that was made says connect: false");
    if (a == regions.size() || b == regions.size())
      faults.add("a link names what is no region");
    else
      joined.join(a, b);
  }
  for (std::size_t i = 0; i < regions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const bool linked = joined.find(i) == joined.find(j), one = regions[i].component == regions[j].component;
      const std::string where = "slices " + std::to_string(regions[j].slice) + ", " + std::to_string(regions[i].slice) +
                                ", contours " + std::to_string(regions[j].contour) + ", " +
                                std::to_string(regions[i].contour);
      if (linked && !one) faults.add("linked regions lie in different pieces", where);
      if (!linked && one) faults.add("regions that no link joins lie in one piece", where);
    }
  std::set<std::size_t> pieces;
  for (const Region& region : regions) pieces.insert(region.component);
  if (pieces.size() != verdict.components) faults.add("a piece of the solid holds no region");
}

}  // namespace

void Faults::add(const std::string& sort, const std::string& where) {
  Sort& entry = sorts_[sort];
  if (entry.count++ == 0) entry.first = where;
}

std::vector<std::string> Faults::list() const {
  std::vector<std::string> lines;
  for (const auto& [sort, entry] : sorts_) {
    std::string line = sort + ", " + std::to_string(entry.count) + " times";
    if (!entry.first.empty()) line += ", first: " + entry.first;
    lines.push_back(line);
  }
  return lines;
}

std::string Verdict::in_words() const {
  std::string words;
  for (const std::string& fault : faults) words += fault + "\n";
  for (const JudgedShell& shell : shells)
    words += kind_name(shell.kind) + " shell, genus " + std::to_string(shell.genus) + ", volume " +
             std::to_string(shell.volume) + "\n";
  return words;
}

std::vector<JudgedSlice> slices_of(const ContourStack& stack, const std::string& structure) {
  std::vector<JudgedSlice> slices;
  for (const Slice& slice : stack.slices) {
    JudgedSlice judged{slice.z, {}};
    for (const Contour& contour : slice.contours)
      if (contour.structure == structure) judged.rings.push_back(contour.points);
    std::vector<bool> flip;
    for (std::size_t i = 0; i < judged.rings.size(); ++i) {
      const int wanted = depth_of(judged.rings, i) % 2 == 0 ? 1 : -1;
      flip.push_back(area_sign(judged.rings[i]) != wanted);
    }
    for (std::size_t i = 0; i < judged.rings.size(); ++i)
      if (flip[i]) std::reverse(judged.rings[i].begin(), judged.rings[i].end());
    slices.push_back(judged);
  }
  std::sort(slices.begin(), slices.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  return slices;
}

Verdict judge(const Solid& solid, const ContourStack& stack, OracleOptions options) {
  const TetraMesh& mesh = solid.tetrahedra;
  const std::vector<JudgedSlice> slices = slices_of(stack, solid.structure);
  Faults faults;
  Verdict verdict;
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (PointIndex v : tetrahedron)
      if (v >= mesh.points.size()) return {{"an index beyond the points"}, {}, {}, 0};
  judge_points(mesh, slices, faults);
  judge_tetrahedra(mesh, slices, faults);
  const std::vector<Triangle> boundary = judge_faces(mesh, faults);
  judge_vertex_links(mesh, faults);
  verdict.component_of = components_of(mesh, verdict.components);
  if (surface_in_solid(solid, faults) != boundary) faults.add("the surface is not the boundary of the tetrahedra");
  if (judge_manifold(boundary, faults)) {
    verdict.shells = judge_shells(mesh, boundary, faults);
    if (options.self_intersections) judge_self_intersections(mesh, boundary, faults);
  }
  judge_volume(mesh, boundary, faults);
  for (const JudgedSlice& slice : slices) judge_section(mesh, slice, faults);
  judge_report(solid, verdict, faults);
  verdict.faults = faults.list();
  return verdict;
}

std::vector<std::string> faults_of(const Reconstruction& result, const ContourStack& stack, OracleOptions options) {
  ContourStack sorted = stack;
  std::sort(sorted.slices.begin(), sorted.slices.end(), [](const Slice& a, const Slice& b) { return a.z < b.z; });
  std::vector<std::string> all;
  std::set<std::string> wanted, made;
  bool sound = true;  // else nothing can be said about topology
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) wanted.insert(contour.structure);
  for (const Solid& solid : result.solids) {
    const Verdict verdict = judge(solid, stack, options);
    for (const std::string& fault : verdict.faults) all.push_back(solid.structure + ": " + fault);
    if (!made.insert(solid.structure).second) all.push_back(solid.structure + ": two solids of one structure");
    sound = sound && verdict.certified();
    if (verdict.component_of.empty()) continue;
    Faults faults;
    judge_links(solid, verdict, result.links, sorted, faults);
    for (const std::string& fault : faults.list()) all.push_back(solid.structure + ": " + fault);
  }
  if (sound) {
    const TopologyVerdict topology = judge_topology(result, sorted);
    for (const std::string& fault : topology.untrue) all.push_back("untrue topology, " + fault);
  }
  if (wanted != made) all.push_back("the solids are not those of the stack's structures");
  if (!result.certified) all.push_back("the engine itself did not certify");
  return all;
}

std::vector<std::string> topology_of(const Reconstruction& result) {
  std::vector<std::string> lines;
  for (const Solid& solid : result.solids)
    for (const Shell& shell : solid.report.shells)
      lines.push_back(solid.structure + " " + kind_name(shell.kind) + " genus " + std::to_string(shell.genus));
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace odontoscope::test
