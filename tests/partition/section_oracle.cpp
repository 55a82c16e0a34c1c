// The part of the partition's oracle that looks at the slices.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "tests/partition/partition_oracle.h"
#include "tests/partition/slice_overlay.h"
#include "tests/support/oracle_parts.h"
#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

Point2 flat(const Point3& p) { return {p.x, p.y}; }

/// What lies in a slice's plane, seen from one side.
struct Section {
  std::map<Triangle, Label> triangles;                         // counter-clockwise from +z, smallest index first
  std::map<Label, std::set<PointIndex>> points;                // that tetrahedra of a label have there
  std::map<Label, std::set<std::array<PointIndex, 2>>> edges;  // smaller index first
};

void add(const TetraMesh& mesh, const std::vector<PointIndex>& flat_part, Label label, Section& section) {
  for (PointIndex a : flat_part) {
    section.points[label].insert(a);
    for (PointIndex b : flat_part)
      if (a < b) section.edges[label].insert({a, b});
  }
  if (flat_part.size() != 3) return;
  Triangle face{flat_part[0], flat_part[1], flat_part[2]};
  if (turn(flat(mesh.points[face[0]]), flat(mesh.points[face[1]]), flat(mesh.points[face[2]])) < 0)
    std::swap(face[1], face[2]);
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  section.triangles[face] = label;
}

std::array<Section, 2> sections_of(const TetraMesh& mesh, double z) {
  std::array<Section, 2> sections;  // from below, from above
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    std::vector<PointIndex> flat_part;
    bool above = false;
    for (PointIndex v : mesh.tetrahedra[t]) {
      if (mesh.points[v].z == z)
        flat_part.push_back(v);
      else
        above = mesh.points[v].z > z;
    }
    if (!flat_part.empty() && flat_part.size() < 4) add(mesh, flat_part, mesh.labels[t], sections[above]);
  }
  return sections;
}

class SectionJudge {
 public:
  SectionJudge(const TetraMesh& mesh, const SliceOverlay& overlay, const Section& section, double gap,
               std::size_t labels, Faults& faults)
      : mesh_(mesh), overlay_(overlay), section_(section), gap_(gap), labels_(labels), faults_(faults) {}

  void judge() {
    judge_nothing_loose();
    judge_borders();
    for (const auto& [triangle, label] : section_.triangles) judge_label(triangle, label);
    judge_points();
    judge_areas();
  }

 private:
  Point2 at(PointIndex v) const { return flat(mesh_.points[v]); }
  void fault(const std::string& what, Point2 p, const std::string& more = {}) {
    std::ostringstream words;
    words.precision(17);
    words << "(" << p.x << ", " << p.y << ")" << more << ", " << overlay_.distance(p) << " off the contours";
    faults_.add(what, words.str());
  }

  void judge_nothing_loose() {
    std::map<Label, std::set<PointIndex>> corners;
    std::map<Label, std::set<std::array<PointIndex, 2>>> sides;
    for (const auto& [t, label] : section_.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        corners[label].insert(t[i]);
        sides[label].insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
      }
    for (const auto& [label, points] : section_.points)
      for (PointIndex v : points)
        if (!corners[label].contains(v)) fault("a label touches a slice in a point outside its faces", at(v));
    for (const auto& [label, edges] : section_.edges)
      for (const auto& edge : edges)
        if (!sides[label].contains(edge)) fault("a label touches a slice in an edge outside its faces", at(edge[0]));
  }

  /// Is this void that the gap allows to be given to the label?
  bool closed(Point2 p, Label label) const {
    return gap_ > 0 && label != void_label && overlay_.distance(p, label) <= gap_ * (1 + 1e-9);
  }

  void judge_borders() {
    std::map<std::array<PointIndex, 2>, Label> left;
    for (const auto& [t, label] : section_.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (!left.insert({{t[i], t[(i + 1) % 3]}, label}).second)
          fault("triangles that overlap in a slice's plane", at(t[i]));
    for (const auto& [edge, label] : left) {
      const auto other = left.find({edge[1], edge[0]});
      const Label beyond = other == left.end() ? void_label : other->second;
      if (beyond == label) continue;
      for (PointIndex v : edge) labels_at_[v].insert({label, beyond});
      const Point2 a = at(edge[0]), b = at(edge[1]), middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
      for (Point2 p : {a, middle, b}) {
        const bool allowed = overlay_.distance(p) <= overlay_.rounding() || overlay_.may_be_cut(p) ||
                             closed(p, label) || closed(p, beyond);
        if (!allowed) fault("a border in a slice's plane that is on no contour", p);
      }
    }
  }

  void judge_label(const Triangle& t, Label label) {
    const Point2 a = at(t[0]), b = at(t[1]), c = at(t[2]);
    constexpr double shares[][3] = {{1 / 3., 1 / 3., 1 / 3.}, {0.9, 0.06, 0.04}, {0.06, 0.9, 0.04}, {0.04, 0.06, 0.9}};
    for (const auto& share : shares) {
      const Point2 p{a.x + share[1] * (b.x - a.x) + share[2] * (c.x - a.x),
                     a.y + share[1] * (b.y - a.y) + share[2] * (c.y - a.y)};
      if (turn(a, b, p) <= 0 || turn(b, c, p) <= 0 || turn(c, a, p) <= 0) continue;  // too thin for its own middle
      const Label wanted = overlay_.label_at(p);
      if (wanted == label || overlay_.distance(p) <= overlay_.rounding() || overlay_.may_be_cut(p)) continue;
      if (wanted != void_label || !closed(p, label))
        fault("a place in a slice with another label than its contours say", p,
              ": " + std::to_string(label) + " for " + std::to_string(wanted));
    }
  }

  void judge_points() {
    std::map<std::pair<double, double>, PointIndex> point_at;
    for (const auto& [t, label] : section_.triangles)
      for (PointIndex v : t) point_at[{at(v).x, at(v).y}] = v;
    for (Point2 p : overlay_.points()) {
      if (!overlay_.clear(p)) continue;
      const std::vector<Label> wanted = overlay_.round(p);
      const bool near_gap = gap_ > 0 && std::count(wanted.begin(), wanted.end(), void_label) > 0;
      if (wanted.size() < 2 || near_gap) continue;
      const auto vertex = point_at.find({p.x, p.y});
      if (vertex == point_at.end()) {
        fault("a given point on a visible border that is no vertex", p);
        continue;
      }
      if (!overlay_.may_be_cut(p) && labels_at_[vertex->second] != std::set<Label>(wanted.begin(), wanted.end()))
        fault("a given point with other labels round it than its contours say", p);
    }
  }

  void judge_areas() {
    std::vector<long double> found(labels_, 0), wanted = overlay_.areas();
    for (const auto& [t, label] : section_.triangles) {
      const Point2 a = at(t[0]), b = at(t[1]), c = at(t[2]);
      found[label - 1] +=
          (((long double)b.x - a.x) * ((long double)c.y - a.y) - ((long double)b.y - a.y) * ((long double)c.x - a.x)) /
          2;
    }
    long double whole = 0;
    for (long double area : wanted) whole += area;
    const long double allowed = overlay_.length() * overlay_.rounding() + overlay_.cut_area() + whole * 1e-15L;
    for (std::size_t i = 0; i < labels_; ++i) {
      const bool more = found[i] > wanted[i] + allowed && gap_ == 0, less = found[i] < wanted[i] - allowed;
      if (more || less)
        faults_.add("a label has another area in a slice than its contours say",
                    std::to_string(double(found[i])) + " for " + std::to_string(double(wanted[i])));
    }
  }

  const TetraMesh& mesh_;
  const SliceOverlay& overlay_;
  const Section& section_;
  double gap_;
  std::size_t labels_;
  Faults& faults_;
  std::map<PointIndex, std::set<Label>> labels_at_;  // of points on borders
};

}  // namespace

std::vector<std::string> section_faults(const LabelledComplex& complex, const ContourStack& stack,
                                        const PartitionRule& rule) {
  Faults faults;
  std::vector<double> heights;
  for (const Slice& slice : stack.slices) heights.push_back(slice.z);
  const double first = *std::min_element(heights.begin(), heights.end()),
               last = *std::max_element(heights.begin(), heights.end());
  for (const Slice& slice : stack.slices) {
    const std::array<Section, 2> sections = sections_of(complex.mesh, slice.z);
    const SliceOverlay overlay(slice, complex.structures, rule);
    const bool inner = slice.z != first && slice.z != last;
    if (inner && sections[0].triangles != sections[1].triangles)
      faults.add("a slice that is not the same from below and from above", "z = " + std::to_string(slice.z));
    for (bool above : {false, true}) {
      if (slice.z == (above ? last : first)) continue;
      Faults of_side;
      SectionJudge(complex.mesh, overlay, sections[above], rule.gap, complex.structures.size(), of_side).judge();
      for (const std::string& fault : of_side.list())
        faults.add(fault.substr(0, fault.find(", ")), "z = " + std::to_string(slice.z) +
                                                          (above ? ", from above" : ", from below") +
                                                          fault.substr(fault.find(", ")));
    }
  }
  return faults.list();
}

}  // namespace odontoscope::test
