#include "recon/partition/overlay.h"

#include <CGAL/Constrained_triangulation_plus_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "recon/delaunay/constrained.h"

namespace odontoscope::partition {
namespace {

using delaunay::Kernel;
using Members = std::uint64_t;   // bit s: inside structure s

struct FaceMembers {
  Members members = 0;
  bool known = false;
  Label label = void_label;
};

using OverlayFaceBase = CGAL::Triangulation_face_base_with_info_2<FaceMembers, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using OverlayStructure = CGAL::Triangulation_data_structure_2<delaunay::VertexBase, OverlayFaceBase>;
using OverlayCdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, OverlayStructure, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<OverlayCdt>;

class Overlayer {
 public:
  Overlayer(const Slice& slice, const Materials& materials) : materials_(materials) {
    std::vector<Kernel::Point_2> points;
    for (const Contour& contour : slice.contours)
      for (const Point2 p : contour.points) points.emplace_back(p.x, p.y);
    std::sort(points.begin(), points.end());
    triangulation_.insert(points.begin(), points.end());
    given_ = triangulation_.number_of_vertices();
    for (const Contour& contour : slice.contours) constrain(contour);
  }

  Borders run() {
    if (triangulation_.dimension() < 2) return {};
    spread();
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face)
      face->info().label = winner(face->info().members);
    Borders result;
    result.crossings = triangulation_.number_of_vertices() - given_;
    if (materials_.gap > 0) result.closed_gap = close_gaps();
    if (materials_.sliver > 0) drop_slivers();
    collect(result);
    return result;
  }

 private:
  /// As one closed polyline, so that borders that two structures share keep both.
  void constrain(const Contour& contour) {
    std::vector<Kernel::Point_2> points;
    for (const Point2 p : contour.points) points.emplace_back(p.x, p.y);
    const auto id = triangulation_.insert_constraint(points.begin(), points.end(), true);
    const auto found = std::find(materials_.structures.begin(), materials_.structures.end(), contour.structure);
    structure_of_[id] = static_cast<std::uint32_t>(found - materials_.structures.begin());
  }

  /// A closed contour toggles its structure for what lies beyond it; rounding may move it, but it stays closed.
  void spread() {
    const auto start = triangulation_.infinite_face();
    start->info().known = true;
    std::vector<Triangulation::Face_handle> stack{start};
    while (!stack.empty()) {
      const auto face = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto other = face->neighbor(i);
        if (other->info().known) continue;
        other->info().known = true;
        other->info().members = face->info().members ^ crossed(face, i);
        stack.push_back(other);
      }
    }
  }

  Members crossed(Triangulation::Face_handle face, int i) const {
    if (!face->is_constrained(i)) return 0;
    Members toggled = 0;
    const auto a = face->vertex(Triangulation::ccw(i)), b = face->vertex(Triangulation::cw(i));
    for (auto context = triangulation_.contexts_begin(a, b); context != triangulation_.contexts_end(a, b); ++context)
      toggled ^= Members{1} << structure_of_.at(context->id());
    return toggled;
  }

  Label winner(Members members) const {
    Label best = void_label;
    for (std::size_t s = 0; s < materials_.structures.size(); ++s)
      if ((members >> s & 1) != 0 && materials_.wins(static_cast<Label>(s + 1), best)) best = static_cast<Label>(s + 1);
    return best;
  }

  // ---- gaps ---------------------------------------------------------------------------------------------------------

  double close_gaps() {
    std::vector<std::pair<Triangulation::Face_handle, Label>> closed;
    double area = 0;
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face) {
      if (face->info().label != void_label) continue;
      const Label taker = gap_taker(face);
      if (taker == void_label) continue;
      closed.emplace_back(face, taker);
      area += std::abs(CGAL::area(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()));
    }
    for (const auto& [face, label] : closed) face->info().label = label;
    return area;
  }

  /// Of a void triangle: the winner of those structures between which it is narrower than the gap. Corners of one structure only: void_label.
  Label gap_taker(Triangulation::Face_handle face) const {
    if (narrowest(face) > materials_.gap) return void_label;
    std::vector<Label> beside;
    for (int i = 0; i < 3; ++i) {
      auto around = triangulation_.incident_faces(face->vertex(i)), end = around;
      do {
        if (label(around) != void_label) beside.push_back(label(around));
      } while (++around != end);
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    if (beside.size() < 2) return void_label;
    Label best = void_label;
    for (const Label one : beside)
      if (materials_.wins(one, best)) best = one;
    return best;
  }

  /// Its least height. A void triangle has corners on both sides of the gap, so no gap is narrower than one of its triangles.
  static double narrowest(Triangulation::Face_handle face) {
    const auto& a = face->vertex(0)->point();
    const auto& b = face->vertex(1)->point();
    const auto& c = face->vertex(2)->point();
    const double longest = std::sqrt(std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)}));
    return 2 * std::abs(CGAL::area(a, b, c)) / longest;
  }

  // ---- slivers ------------------------------------------------------------------------------------------------------

  struct Piece {
    std::vector<Triangulation::Face_handle> faces;
    double area = 0, around = 0;
    std::map<Label, double> beside;   // length of common border
    bool outer = false;
  };

  /// Faces with little area for their circumference, to the neighbour with the longest common border.
  void drop_slivers() {
    for (auto face = triangulation_.all_faces_begin(); face != triangulation_.all_faces_end(); ++face) face->info().known = false;
    std::vector<std::pair<std::vector<Triangulation::Face_handle>, Label>> dropped;
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end(); ++face) {
      if (face->info().known) continue;
      Piece piece = piece_at(face);
      if (piece.outer || 2 * piece.area >= materials_.sliver * piece.around) continue;
      const auto longest = std::max_element(piece.beside.begin(), piece.beside.end(), [](const auto& p, const auto& q) { return p.second < q.second; });
      dropped.emplace_back(std::move(piece.faces), longest->first);
    }
    for (const auto& [faces, label] : dropped)
      for (const auto& face : faces) face->info().label = label;
  }

  Piece piece_at(Triangulation::Face_handle start) {
    Piece piece;
    std::vector<Triangulation::Face_handle> stack{start};
    start->info().known = true;
    while (!stack.empty()) {
      const auto face = stack.back();
      stack.pop_back();
      piece.faces.push_back(face);
      piece.area += std::abs(CGAL::area(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()));
      for (int i = 0; i < 3; ++i) {
        const auto other = face->neighbor(i);
        if (label(other) != label(start)) {
          const double length = std::sqrt(CGAL::squared_distance(face->vertex(Triangulation::ccw(i))->point(), face->vertex(Triangulation::cw(i))->point()));
          piece.around += length;
          piece.beside[label(other)] += length;
        } else if (triangulation_.is_infinite(other)) {
          piece.outer = true;
        } else if (!other->info().known) {
          other->info().known = true;
          stack.push_back(other);
        }
      }
    }
    return piece;
  }

  // ---- borders ------------------------------------------------------------------------------------------------------

  Label label(Triangulation::Face_handle face) const { return triangulation_.is_infinite(face) ? void_label : face->info().label; }

  void collect(Borders& result) {
    std::vector<std::pair<Point2, Point2>> ends;
    std::vector<std::pair<Label, Label>> sides;
    for (auto edge = triangulation_.finite_edges_begin(); edge != triangulation_.finite_edges_end(); ++edge) {
      const Label left = label(edge->first), right = label(edge->first->neighbor(edge->second));
      if (left == right) continue;
      const auto& a = edge->first->vertex(Triangulation::ccw(edge->second))->point();
      const auto& b = edge->first->vertex(Triangulation::cw(edge->second))->point();
      ends.push_back({{a.x(), a.y()}, {b.x(), b.y()}});
      sides.emplace_back(left, right);
    }
    const auto before = [](Point2 p, Point2 q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    for (const auto& [a, b] : ends) result.points.insert(result.points.end(), {a, b});
    std::sort(result.points.begin(), result.points.end(), before);
    result.points.erase(std::unique(result.points.begin(), result.points.end()), result.points.end());
    const auto number = [&](Point2 p) {
      return static_cast<std::uint32_t>(std::lower_bound(result.points.begin(), result.points.end(), p, before) - result.points.begin());
    };
    for (std::size_t i = 0; i < ends.size(); ++i) {
      Border border{number(ends[i].first), number(ends[i].second), sides[i].first, sides[i].second};
      if (border.a > border.b) border = {border.b, border.a, border.right, border.left};
      result.pieces.push_back(border);
    }
    std::sort(result.pieces.begin(), result.pieces.end(),
              [](const Border& p, const Border& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
  }

  const Materials& materials_;
  Triangulation triangulation_;
  std::map<Triangulation::Constraint_id, std::uint32_t> structure_of_;
  std::size_t given_ = 0;
};

}  // namespace

Borders overlay(const Slice& slice, const Materials& materials) { return Overlayer(slice, materials).run(); }

}  // namespace odontoscope::partition
