#include "tests/partition/partition_oracle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/oracle_parts.h"

namespace odontoscope::test {
namespace {

using Bits = std::array<std::uint64_t, 3>;

/// More triangles than this are judged for meeting themselves in seconds only.
constexpr std::size_t judged_triangles = 6000;

Bits bits_of(const Point3& p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y), std::bit_cast<std::uint64_t>(p.z)};
}

Triangle from_smallest(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::array<Triangle, 4> outward(const Tetrahedron& t) {
  const auto [a, b, c, d] = t;
  return {Triangle{a, c, b}, Triangle{a, b, d}, Triangle{b, c, d}, Triangle{a, d, c}};
}

TetraMesh part_of(const TetraMesh& mesh, Label label) {
  TetraMesh part;
  part.points = mesh.points;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (mesh.labels[t] == label) {
      part.tetrahedra.push_back(mesh.tetrahedra[t]);
      part.labels.push_back(label);
    }
  return part;
}

void append(std::vector<std::string>& all, const std::string& prefix, const std::vector<std::string>& some) {
  for (const std::string& line : some) all.push_back(prefix + line);
}

bool sound(const LabelledComplex& complex, Faults& faults) {
  const TetraMesh& mesh = complex.mesh;
  if (mesh.labels.size() != mesh.tetrahedra.size()) faults.add("not one label for each tetrahedron");
  for (Label label : mesh.labels)
    if (label == void_label || label > complex.structures.size()) faults.add("a label of no structure");
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (PointIndex v : t)
      if (v >= mesh.points.size()) faults.add("an index beyond the points");
  for (const InterfaceTriangle& face : complex.interfaces)
    for (PointIndex v : face.triangle)
      if (v >= mesh.points.size()) faults.add("an index of an interface beyond the points");
  return faults.list().empty();
}

void judge_interfaces(const LabelledComplex& complex, Faults& faults) {
  std::map<Triangle, Label> inside;
  for (std::size_t t = 0; t < complex.mesh.tetrahedra.size(); ++t)
    for (const Triangle& face : outward(complex.mesh.tetrahedra[t]))
      inside[from_smallest(face)] = complex.mesh.labels[t];
  std::set<std::tuple<Triangle, Label, Label>> wanted, listed;
  for (const auto& [face, label] : inside) {
    const auto other = inside.find(from_smallest({face[0], face[2], face[1]}));
    const Label beyond = other == inside.end() ? void_label : other->second;
    if (beyond == void_label || label < beyond) wanted.insert({face, label, beyond});
  }
  for (const InterfaceTriangle& face : complex.interfaces)
    if (!listed.insert({from_smallest(face.triangle), face.inner, face.outer}).second)
      faults.add("an interface listed twice");
  for (const auto& face : wanted)
    if (!listed.contains(face)) faults.add("a face between two labels that is not among the interfaces, or not so");
  for (const auto& face : listed)
    if (!wanted.contains(face)) faults.add("an interface that is no face between these labels, or turned wrongly");
}

std::vector<std::array<Bits, 3>> in_bits(const std::vector<Point3>& points, const std::vector<Triangle>& triangles) {
  std::vector<std::array<Bits, 3>> all;
  for (const Triangle& t : triangles) {
    std::array<Bits, 3> corners{bits_of(points[t[0]]), bits_of(points[t[1]]), bits_of(points[t[2]])};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<std::array<Bits, 4>> in_bits(const TetraMesh& mesh) {
  std::vector<std::array<Bits, 4>> all;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    std::array<Bits, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = bits_of(mesh.points[t[i]]);
    std::sort(corners.begin(), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void judge_solid(const Solid& solid, const TetraMesh& part, const std::vector<Triangle>& boundary,
                 const std::vector<JudgedSlice>& slices, Faults& faults) {
  for (const Tetrahedron& t : solid.tetrahedra.tetrahedra)
    for (PointIndex v : t)
      if (v >= solid.tetrahedra.points.size()) return faults.add("an index of a solid beyond its points");
  for (const Triangle& t : solid.surface.triangles)
    for (PointIndex v : t)
      if (v >= solid.surface.points.size()) return faults.add("an index of a surface beyond its points");
  if (in_bits(solid.tetrahedra) != in_bits(part)) faults.add("the solid's tetrahedra are not the complex's");
  if (in_bits(solid.surface.points, solid.surface.triangles) != in_bits(part.points, boundary))
    faults.add("the solid's surface is not its boundary in the complex");
  judge_points(solid.tetrahedra, slices, faults);
  judge_tetrahedra(solid.tetrahedra, slices, faults);
}

void judge_report(const Solid& solid, const std::vector<JudgedShell>& shells, Faults& faults) {
  std::vector<std::pair<Shell::Kind, long>> told, found;
  for (const Shell& shell : solid.report.shells) told.emplace_back(shell.kind, shell.genus);
  for (const JudgedShell& shell : shells) found.emplace_back(shell.kind, shell.genus);
  std::sort(told.begin(), told.end());
  std::sort(found.begin(), found.end());
  if (told != found) faults.add("the report's shells are not those of the surface");
  if (!solid.report.closed_oriented_manifold()) faults.add("the report denies that the surface is a manifold");
}

/// One material, or all together (label 0).
void judge_material(const Reconstruction& result, Label label, const std::vector<JudgedSlice>& slices, Faults& faults) {
  const LabelledComplex& complex = *result.complex;
  const TetraMesh part = label == void_label ? complex.mesh : part_of(complex.mesh, label);
  const std::vector<Triangle> boundary = judge_faces(part, faults);
  judge_vertex_links(part, faults);
  std::vector<JudgedShell> shells;
  if (judge_manifold(boundary, faults) && !boundary.empty()) {
    shells = judge_shells(part, boundary, faults);
    if (label == void_label && boundary.size() <= judged_triangles) judge_self_intersections(part, boundary, faults);
  }
  judge_volume(part, boundary, faults);
  if (label == void_label) return;
  const std::string& structure = complex.structures[label - 1];
  const auto of_structure = [&](const Solid& solid) { return solid.structure == structure; };
  const auto solid = std::find_if(result.solids.begin(), result.solids.end(), of_structure);
  const auto solids = std::count_if(result.solids.begin(), result.solids.end(), of_structure);
  if (solids > 1) faults.add("two solids of one structure");
  if (solid == result.solids.end()) {
    if (!part.tetrahedra.empty()) faults.add("no solid for a material");
    return;
  }
  if (part.tetrahedra.empty()) return;
  judge_solid(*solid, part, boundary, slices, faults);
  judge_report(*solid, shells, faults);
}

}  // namespace

std::vector<std::string> partition_faults(const Reconstruction& result, const ContourStack& stack,
                                          const PartitionRule& rule) {
  if (!result.complex) return {"no complex"};
  const LabelledComplex& complex = *result.complex;
  Faults whole;
  if (!sound(complex, whole)) return whole.list();
  if (!result.certified) whole.add("not certified");
  std::vector<JudgedSlice> slices;
  for (const Slice& slice : stack.slices) slices.push_back({slice.z, {}});
  std::sort(slices.begin(), slices.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  std::set<std::string> drawn;
  for (const Slice& slice : stack.slices)
    for (const Contour& contour : slice.contours) drawn.insert(contour.structure);
  if (std::set<std::string>(complex.structures.begin(), complex.structures.end()) != drawn ||
      complex.structures.size() != drawn.size())
    whole.add("the structures are not the stack's");
  for (const Solid& solid : result.solids)
    if (!drawn.contains(solid.structure)) whole.add("a solid of no structure");
  judge_points(complex.mesh, slices, whole);
  judge_tetrahedra(complex.mesh, slices, whole);
  judge_interfaces(complex, whole);
  judge_material(result, void_label, slices, whole);
  std::vector<std::string> faults = whole.list();
  for (Label label = 1; label <= complex.structures.size(); ++label) {
    Faults of_material;
    judge_material(result, label, slices, of_material);
    append(faults, "of a material: ", of_material.list());
  }
  append(faults, "", section_faults(complex, stack, rule));
  return faults;
}

}  // namespace odontoscope::test
