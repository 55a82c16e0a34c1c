#include "recon/partition/contour_overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/polygon.h"
#include "recon/core/portable_math.h"
#include "recon/core/spatial_order.h"
#include "recon/delaunay/predicates.h"
#include "recon/partition/limits.h"
#include "recon/partition/overlay_faces.h"
#include "recon/partition/planar_pieces.h"

namespace odontoscope::partition {
namespace {

/// The corner at `at` that begins at the border towards `first` goes to `taker`.
struct CornerCut {
  std::uint32_t at = 0, first = 0;
  double reach = 0;  // nothing farther from `at` is given away
  Label taker = void_label;
  bool whole = false;  // too narrow for a cut: the triangles at the point go as they are
};

class Overlayer {
 public:
  Overlayer(const Slice& slice, const Materials& materials) : materials_(materials) {
    std::map<std::pair<double, double>, std::uint32_t> numbers;
    for (const Contour& contour : slice.contours) {
      const auto found = std::find(materials.structures.begin(), materials.structures.end(), contour.structure);
      const Members toggled = Members{1} << (found - materials.structures.begin());
      std::vector<std::uint32_t> ring;
      for (const Point2 p : contour.points) {
        const auto [known, fresh] = numbers.emplace(std::pair(p.x, p.y), static_cast<std::uint32_t>(points_.size()));
        if (fresh) points_.push_back(p);
        ring.push_back(known->second);
      }
      for (std::size_t i = 0; i < ring.size(); ++i) pieces_.push_back({ring[i], ring[(i + 1) % ring.size()], toggled});
    }
  }

  Borders run() {
    Borders result;
    result.crossings = make_planar(points_, pieces_);
    triangulate();
    if (cdt_.dimension() < 2) return result;
    label_faces();
    if (materials_.gap > 0 || materials_.sliver > 0) {
      if (materials_.gap > 0) result.closed_gap = close_gaps(cdt_, materials_);
      if (materials_.sliver > 0) drop_slivers(cdt_, materials_);
      if (!keep_labels()) return result;
    }
    for (std::size_t round = 0; cut_corners(round >= limits::cutting_rounds); ++round) {
      if (round == limits::corner_rounds) throw InternalError("the corners of a slice could not be parted");
      triangulate();
      label_faces();
      for (const CornerCut& cut : cuts_) apply(cut);
    }
    result.corners_cut = cuts_.size();
    collect(result);
    return result;
  }

 private:
  /// From here on a piece parts two labels, whatever structures it came from; `toggles` is their difference. False:
  /// nothing is left.
  bool keep_labels() {
    pieces_.clear();
    for (auto edge = cdt_.finite_edges_begin(); edge != cdt_.finite_edges_end(); ++edge) {
      const Label one = label(edge->first), other = label(edge->first->neighbor(edge->second));
      if (one == other) continue;
      const auto [a, b] = std::minmax({edge->first->vertex(Overlay::ccw(edge->second))->info().value,
                                       edge->first->vertex(Overlay::cw(edge->second))->info().value});
      pieces_.push_back({a, b, Members{one} ^ Members{other}});
    }
    // Which way round an edge is told, and when, depends on where its triangles lie in memory.
    std::sort(pieces_.begin(), pieces_.end(),
              [](const ContourPiece& p, const ContourPiece& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
    part_labels_ = true;
    if (pieces_.empty()) return false;
    make_planar(points_, pieces_);
    triangulate();
    label_faces();
    return true;
  }

  void triangulate() {
    cdt_.clear();
    vertices_.assign(points_.size(), {});
    Overlay::Face_handle hint;
    for (const std::uint32_t p : spatial_order(points_)) {
      vertices_[p] = cdt_.insert(Kernel::Point_2(points_[p].x, points_[p].y), hint);
      vertices_[p]->info().value = p;
      hint = vertices_[p]->face();
    }
    toggles_.clear();
    for (const ContourPiece& piece : pieces_) {
      cdt_.insert_constraint(vertices_[piece.a], vertices_[piece.b]);
      toggles_[{piece.a, piece.b}] = piece.toggles;
    }
  }

  void label_faces() {
    spread();
    for (auto face = cdt_.finite_faces_begin(); face != cdt_.finite_faces_end(); ++face)
      face->info().label = part_labels_ ? static_cast<Label>(face->info().members) : winner(face->info().members);
    if (part_labels_ || materials_.stand_ins.empty()) return;
    for (auto face = cdt_.finite_faces_begin(); face != cdt_.finite_faces_end(); ++face)
      if (label(face) > materials_.own_labels()) settle_stand_in(face);
  }

  /// All faces of one stand-in that hang together get one label.
  void settle_stand_in(Overlay::Face_handle start) {
    const Label standing = label(start);
    const auto& [inner, outer] = materials_.stand_ins[standing - 1 - materials_.own_labels()];
    bool borders_on_inner = false;
    std::vector<Overlay::Face_handle> piece{start};
    start->info().label = outer;
    for (std::size_t n = 0; n < piece.size(); ++n)
      for (int i = 0; i < 3; ++i) {
        const auto other = piece[n]->neighbor(i);
        borders_on_inner = borders_on_inner || label(other) == inner;
        if (label(other) != standing) continue;
        other->info().label = outer;
        piece.push_back(other);
      }
    if (!borders_on_inner) return;
    for (const auto& face : piece) face->info().label = inner;
  }

  /// Every piece toggles its structures for what lies beyond it; rounding may have moved it, but contours stay closed.
  void spread() {
    for (auto face = cdt_.all_faces_begin(); face != cdt_.all_faces_end(); ++face) face->info() = {};
    const auto start = cdt_.infinite_face();
    start->info().known = true;
    std::vector<Overlay::Face_handle> stack{start};
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

  Members crossed(Overlay::Face_handle face, int i) const {
    if (!face->is_constrained(i)) return 0;
    const auto [a, b] =
        std::minmax(face->vertex(Overlay::ccw(i))->info().value, face->vertex(Overlay::cw(i))->info().value);
    return toggles_.at({a, b});
  }

  Label winner(Members members) const {
    Label best = void_label;
    for (std::size_t s = 0; s < materials_.structures.size(); ++s)
      if ((members >> s & 1) != 0 && materials_.wins(static_cast<Label>(s + 1), best)) best = static_cast<Label>(s + 1);
    return best;
  }

  /// A border seen from one end; the face on its left is that between it and the next one counter-clockwise.
  struct Ray {
    std::uint32_t to = 0;
    Overlay::Face_handle left_face;
    Label left = void_label;
  };

  std::vector<Ray> rays_at(Overlay::Vertex_handle at) const {
    std::vector<Ray> rays;
    auto face = cdt_.incident_faces(at), end = face;
    do {  // counter-clockwise
      const int i = face->index(at);
      const auto before = face->neighbor(Overlay::cw(i));  // across the edge from `at` to the next corner
      if (label(face) != label(before))
        rays.push_back({face->vertex(Overlay::ccw(i))->info().value, face, label(face)});
    } while (++face != end);
    for (Ray& ray : rays)
      if (ray.to == delaunay::none) throw InternalError("a border runs to infinity");
    return rays;
  }

  double angle(std::uint32_t at, std::uint32_t from, std::uint32_t to) const {
    const Point2 p = points_[at], a = points_[from], b = points_[to];
    const double turned = portable::atan2(b.y - p.y, b.x - p.x) - portable::atan2(a.y - p.y, a.x - p.x);
    return turned < 0 ? turned + 2 * std::numbers::pi : turned;
  }

  /// Plans one cut at every point where more than three borders meet. Upwards: only faces of least priority give, whole
  /// triangles, so that it must end. False: there is none.
  bool cut_corners(bool upwards) {
    std::vector<std::uint32_t> crowded;
    for (auto v = cdt_.finite_vertices_begin(); v != cdt_.finite_vertices_end(); ++v)
      crowded.push_back(v->info().value);
    std::sort(crowded.begin(), crowded.end());
    std::erase_if(crowded, [&](std::uint32_t p) { return rays_at(vertices_[p]).size() <= 3; });
    if (crowded.empty()) return false;
    std::vector<bool> taken(points_.size(), false);  // a border is cut from one end at a time
    for (const std::uint32_t p : crowded) {
      const std::vector<Ray> rays = rays_at(vertices_[p]);
      if (taken[p] || std::any_of(rays.begin(), rays.end(), [&](const Ray& ray) { return taken[ray.to]; })) continue;
      taken[p] = true;
      for (const Ray& ray : rays) taken[ray.to] = true;
      if (upwards)
        plan_upwards(p, rays);
      else
        plan_cut(p, rays);
    }
    make_planar(points_, pieces_);
    return true;
  }

  void plan_upwards(std::uint32_t at, const std::vector<Ray>& rays) {
    const std::size_t count = rays.size();
    std::size_t chosen = count;
    Label taker = void_label;
    for (std::size_t i = 0; i < count; ++i) {
      if (cdt_.is_infinite(rays[i].left_face)) continue;  // nothing there to give
      const Label one = rays[(i + count - 1) % count].left, other = rays[(i + 1) % count].left;
      const Label winner = materials_.wins(one, other) ? one : other;
      if (!materials_.wins(winner, rays[i].left) ||
          (chosen < count && !materials_.wins(rays[chosen].left, rays[i].left)))
        continue;
      chosen = i;
      taker = winner;
    }
    if (chosen == count) throw InternalError("no face at a crowded point can give way");
    cuts_.push_back({at, rays[chosen].to, 0, taker, true});
  }

  void plan_cut(std::uint32_t at, const std::vector<Ray>& rays) {
    const std::size_t count = rays.size();
    const auto repeated = [&](Label label) {
      return std::count_if(rays.begin(), rays.end(), [label](const Ray& ray) { return ray.left == label; }) > 1;
    };
    const auto class_of = [&](Label label) { return !repeated(label) ? 2 : label == void_label ? 1 : 0; };
    std::size_t chosen = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) {
      const double turned = angle(at, rays[i].to, rays[(i + 1) % count].to);
      const double cost = 10 * class_of(rays[i].left) + turned + (turned >= std::numbers::pi ? 100 : 0);
      if (cost >= least) continue;
      least = cost;
      chosen = i;
    }
    const Label one = rays[(chosen + count - 1) % count].left, other = rays[(chosen + 1) % count].left;
    const bool parted = class_of(rays[chosen].left) ==
                        0;  // a material that meets itself: its corner goes to void, if there is any beside it
    const bool takes_one =
        parted && (one == void_label) != (other == void_label) ? one == void_label : materials_.wins(one, other);
    const Label taker = takes_one ? one : other;
    const std::uint32_t ends[] = {rays[chosen].to, rays[(chosen + 1) % count].to};
    const double reach = limits::corner_share * room(at);
    const Point2 cuts[] = {on_piece(at, ends[0], reach), on_piece(at, ends[1], reach)};
    const bool needle = portable::hypot(cuts[0].x - cuts[1].x, cuts[0].y - cuts[1].y) <= limits::needle_share * reach;
    if (needle || is_point(cuts[0]) || is_point(cuts[1])) {
      cuts_.push_back({at, ends[0], 0, taker, true});
      return;
    }
    const std::uint32_t first = cut_at(at, ends[0], cuts[0]), second = cut_at(at, ends[1], cuts[1]);
    pieces_.push_back({first, second, 0});
    cuts_.push_back({at, first, reach, taker, false});
  }

  bool is_point(Point2 p) const { return std::find(points_.begin(), points_.end(), p) != points_.end(); }

  Point2 on_piece(std::uint32_t at, std::uint32_t to, double reach) const {
    const Point2 from = points_[at], end = points_[to];
    const double share = reach / portable::hypot(end.x - from.x, end.y - from.y);
    return {from.x + share * (end.x - from.x), from.y + share * (end.y - from.y)};
  }

  /// A new point on the piece between two points.
  std::uint32_t cut_at(std::uint32_t at, std::uint32_t to, Point2 place) {
    const auto middle = static_cast<std::uint32_t>(points_.size());
    points_.push_back(place);
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(at, to);
    const auto piece = std::find_if(pieces_.begin(), pieces_.end(),
                                    [&](const ContourPiece& p) { return std::pair(p.a, p.b) == ends; });
    const Members toggled =
        piece == pieces_.end() ? 0 : piece->toggles;  // what a corner was given away whole need not have one
    if (piece != pieces_.end()) pieces_.erase(piece);
    pieces_.push_back({at, middle, toggled});
    pieces_.push_back({middle, to, toggled});
    return middle;
  }

  /// The distance to the nearest piece that does not end at the point, and to the nearest other end of those that do.
  double room(std::uint32_t at) const {
    double least = std::numeric_limits<double>::max();
    const Point2 p = points_[at];
    const auto distance = [&](Point2 q) { return portable::hypot(q.x - p.x, q.y - p.y); };
    for (const ContourPiece& piece : pieces_) {
      const Point2 a = points_[piece.a], b = points_[piece.b];
      if (piece.a != at) least = std::min(least, distance(a));
      if (piece.b != at) least = std::min(least, distance(b));
      if (piece.a == at || piece.b == at) continue;
      least = std::min(least, distance_to_edge(p, a, b));
    }
    return least;
  }

  /// Faces of the corner, up to the pieces around it.
  void apply(const CornerCut& cut) {
    const auto rays = rays_at(vertices_[cut.at]);
    if (rays.empty()) return;
    const auto off = [&](const Ray& ray) {
      if (ray.to == cut.first) return -1.0;  // needles: directions alone do not tell which
      const double turned = angle(cut.at, cut.first, ray.to);
      return std::min(turned, 2 * std::numbers::pi - turned);
    };
    const auto start =
        std::min_element(rays.begin(), rays.end(), [&](const Ray& a, const Ray& b) { return off(a) < off(b); });
    const Label loser = start->left;
    if (loser == cut.taker) return;  // a later cut beside it gave it away already
    if (cut.whole) {
      auto face = cdt_.incident_faces(vertices_[cut.at], start->left_face);
      for (const auto end = face; face->info().label == loser && !cdt_.is_infinite(face);) {
        face->info().label = cut.taker;
        if (++face == end) break;
      }
      return;
    }
    constexpr double rounding = 1.001;
    const Kernel::Point_2 at = vertices_[cut.at]->point();
    const auto within = [&](Overlay::Face_handle face) {
      for (int i = 0; i < 3; ++i)
        if (std::sqrt(CGAL::squared_distance(at, face->vertex(i)->point())) > rounding * cut.reach) return false;
      return true;
    };
    if (!within(start->left_face)) return;
    std::vector<Overlay::Face_handle> stack{start->left_face};
    start->left_face->info().label = cut.taker;
    while (!stack.empty()) {
      const auto face = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto other = face->neighbor(i);
        if (face->is_constrained(i) || cdt_.is_infinite(other) || other->info().label != loser || !within(other))
          continue;
        other->info().label = cut.taker;
        stack.push_back(other);
      }
    }
  }

  Label label(Overlay::Face_handle face) const { return label_of(cdt_, face); }

  void collect(Borders& result) {
    std::vector<std::pair<Point2, Point2>> ends;
    std::vector<std::pair<Label, Label>> sides;
    for (auto edge = cdt_.finite_edges_begin(); edge != cdt_.finite_edges_end(); ++edge) {
      const Label left = label(edge->first), right = label(edge->first->neighbor(edge->second));
      if (left == right) continue;
      const auto& a = edge->first->vertex(Overlay::ccw(edge->second))->point();
      const auto& b = edge->first->vertex(Overlay::cw(edge->second))->point();
      ends.push_back({{a.x(), a.y()}, {b.x(), b.y()}});
      sides.emplace_back(left, right);
    }
    const auto before = [](Point2 p, Point2 q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    for (const auto& [a, b] : ends) result.points.insert(result.points.end(), {a, b});
    std::sort(result.points.begin(), result.points.end(), before);
    result.points.erase(std::unique(result.points.begin(), result.points.end()), result.points.end());
    const auto number = [&](Point2 p) {
      return static_cast<std::uint32_t>(std::lower_bound(result.points.begin(), result.points.end(), p, before) -
                                        result.points.begin());
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
  std::vector<Point2> points_;
  std::vector<ContourPiece> pieces_;
  Overlay cdt_;
  std::vector<Overlay::Vertex_handle> vertices_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Members> toggles_;  // of pieces, by their ends
  std::vector<CornerCut> cuts_;
  bool part_labels_ = false;  // see keep_labels
};

}  // namespace

Borders overlay(const Slice& slice, const Materials& materials) { return Overlayer(slice, materials).run(); }

}  // namespace odontoscope::partition
