#include "recon/elements/fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "recon/core/work_apart.h"
#include "recon/delaunay/face_table.h"
#include "recon/elements/limits.h"
#include "recon/mesh/complex_parts.h"
#include "recon/mesh/exact_predicates.h"

#ifdef ODONTOSCOPE_TETGEN
#define TETLIBRARY
#include <tetgen.h>
#endif

namespace odontoscope::elements {
namespace {

/// As TetGen gives them: no labels yet, void filled, turned as it likes.
struct Filling {
  std::vector<Point3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::array<int, 4>> neighbours;  // opposite each corner; -1: none
};

#ifdef ODONTOSCOPE_TETGEN

void hand_over(const LabelledComplex& bounds, tetgenio& in) {
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(bounds.mesh.points.size());
  in.pointlist = new REAL[3 * bounds.mesh.points.size()];
  std::memcpy(in.pointlist, bounds.mesh.points.data(), bounds.mesh.points.size() * sizeof(Point3));
  in.numberoffacets = static_cast<int>(bounds.interfaces.size());
  in.facetlist = new tetgenio::facet[bounds.interfaces.size()];
  in.facetmarkerlist = new int[bounds.interfaces.size()];
  for (std::size_t f = 0; f < bounds.interfaces.size(); ++f) {
    tetgenio::facet& facet = in.facetlist[f];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    facet.polygonlist->numberofvertices = 3;
    facet.polygonlist->vertexlist = new int[3];
    for (int i = 0; i < 3; ++i) facet.polygonlist->vertexlist[i] = static_cast<int>(bounds.interfaces[f].triangle[i]);
    in.facetmarkerlist[f] = static_cast<int>(f + 1);  // unlike each other, so that none are merged
  }
}

template <class Item>
void send_all(const SendToParent& send, const Item* items, std::size_t count) {
  send(reinterpret_cast<const char*>(&count), sizeof(count));
  send(reinterpret_cast<const char*>(items), count * sizeof(Item));
}

void be_tetgen(const LabelledComplex& bounds, std::string switches, const SendToParent& send) {
  tetgenio in, out;
  hand_over(bounds, in);
  ::tetrahedralize(switches.data(), &in, &out);
  send_all(send, out.pointlist, 3 * static_cast<std::size_t>(out.numberofpoints));
  send_all(send, out.tetrahedronlist, 4 * static_cast<std::size_t>(out.numberoftetrahedra));
  send_all(send, out.neighborlist, 4 * static_cast<std::size_t>(out.numberoftetrahedra));
}

/// Takes one list off the front of what came. False if it is not all there.
template <class Item>
bool take(const std::string& sent, std::size_t& at, std::vector<Item>& items, std::size_t of_each) {
  std::size_t count = 0;
  if (sent.size() - at < sizeof(count)) return false;
  std::memcpy(&count, sent.data() + at, sizeof(count));
  at += sizeof(count);
  const std::size_t bytes = count / of_each * sizeof(Item);
  if (count % of_each != 0 || sent.size() - at < bytes) return false;
  items.resize(count / of_each);
  std::memcpy(items.data(), sent.data() + at, bytes);
  at += bytes;
  return true;
}

std::optional<Filling> filling(const LabelledComplex& bounds, const std::string& switches, const Progress& progress) {
  const ApartLimits allowed{limits::fill_seconds, limits::fill_seconds_by_clock, limits::fill_bytes};
  const DoneApart done =
      work_apart([&](const SendToParent& send) { be_tetgen(bounds, switches, send); }, allowed, progress);
  Filling filled;
  std::size_t at = 0;
  if (!done.whole || !take(done.sent, at, filled.points, 3) || !take(done.sent, at, filled.tetrahedra, 4) ||
      !take(done.sent, at, filled.neighbours, 4))
    return std::nullopt;
  for (const Tetrahedron& tet : filled.tetrahedra)
    for (const PointIndex v : tet)
      if (v >= filled.points.size()) return std::nullopt;
  for (const auto& beside : filled.neighbours)
    for (const int t : beside)
      if (t >= static_cast<int>(filled.tetrahedra.size())) return std::nullopt;
  return filled;
}

#endif

/// Labels spread from the faces of the interfaces, which know what lies on either side, to all that no interface parts
/// from there. Nothing if two contradict each other or a face is missing: then this is no filling.
std::optional<std::vector<Label>> labels_of(const Filling& filled, const LabelledComplex& bounds) {
  constexpr Label unknown = static_cast<Label>(-1);
  delaunay::FaceTable walls(bounds.interfaces.size());
  for (std::uint32_t f = 0; f < bounds.interfaces.size(); ++f) {
    const Triangle& t = bounds.interfaces[f].triangle;
    walls(t[0], t[1], t[2]) = f;
  }
  std::vector<Label> labels(filled.tetrahedra.size(), unknown);
  std::vector<std::uint32_t> reached;
  std::vector<std::array<char, 4>> walled(filled.tetrahedra.size(), {0, 0, 0, 0});
  const auto give = [&](std::uint32_t t, Label label) {
    if (labels[t] == unknown) labels[t] = label, reached.push_back(t);
    return labels[t] == label;
  };
  for (std::uint32_t t = 0; t < filled.tetrahedra.size(); ++t) {
    const Tetrahedron& tet = filled.tetrahedra[t];
    for (int i = 0; i < 4; ++i) {
      const PointIndex a = tet[outward_face[i][0]], b = tet[outward_face[i][1]], c = tet[outward_face[i][2]];
      const std::uint32_t wall = walls(a, b, c);
      if (wall == delaunay::FaceTable::vacant) continue;
      walled[t][i] = 1;
      // The face looks outwards from the tetrahedron: if it is turned as the interface is, the tetrahedron is on its
      // inner side.
      const InterfaceTriangle& face = bounds.interfaces[wall];
      const bool alike = delaunay::even_permutation({a, b, c}) == delaunay::even_permutation(face.triangle);
      if (!give(t, alike ? face.inner : face.outer)) return std::nullopt;
    }
  }
  while (!reached.empty()) {
    const std::uint32_t t = reached.back();
    reached.pop_back();
    for (int i = 0; i < 4; ++i) {
      const int beside = filled.neighbours[t][i];
      if (beside >= 0 && !walled[t][i] && !give(static_cast<std::uint32_t>(beside), labels[t])) return std::nullopt;
    }
  }
  for (Label& label : labels)
    if (label == unknown) label = void_label;
  return labels;
}

std::optional<LabelledComplex> labelled(Filling filled, const LabelledComplex& bounds) {
  if (filled.points.size() < bounds.mesh.points.size() ||
      !std::equal(bounds.mesh.points.begin(), bounds.mesh.points.end(), filled.points.begin()))
    return std::nullopt;
  for (std::size_t t = 0; t < filled.tetrahedra.size(); ++t) {
    Tetrahedron& tet = filled.tetrahedra[t];
    const auto& p = filled.points;
    if (orientation(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]) > 0) continue;
    std::swap(tet[2], tet[3]);
    std::swap(filled.neighbours[t][2], filled.neighbours[t][3]);
  }
  auto labels = labels_of(filled, bounds);
  if (!labels) return std::nullopt;
  return LabelledComplex{bounds.structures,
                         {std::move(filled.points), std::move(filled.tetrahedra), std::move(*labels)},
                         bounds.interfaces};
}

}  // namespace

void drop_void(LabelledComplex& complex) {
  TetraMesh& mesh = complex.mesh;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    if (mesh.labels[t] == void_label) continue;
    mesh.tetrahedra[kept] = mesh.tetrahedra[t];
    mesh.labels[kept++] = mesh.labels[t];
  }
  mesh.tetrahedra.resize(kept);
  mesh.labels.resize(kept);
  drop_unused(complex);
}

#ifdef ODONTOSCOPE_TETGEN

bool can_fill() { return true; }

std::optional<LabelledComplex> fill(const LabelledComplex& bounds, double volume, const Progress& progress) {
  // The better, the sooner it may find no end; so it is asked for less and less. -Y: the interfaces stay as they are.
  for (const char* quality : {"q1.4/15O9/7", "q2/10O5/7", "q5/5O2", ""}) {
    progress.check();
    auto filled =
        filling(bounds, fmt::format("pYnQ{}{}", quality, *quality ? fmt::format("a{:.9f}", volume) : ""), progress);
    if (!filled) continue;
    if (auto made = labelled(std::move(*filled), bounds)) return made;
  }
  return std::nullopt;
}

#else

bool can_fill() { return false; }
std::optional<LabelledComplex> fill(const LabelledComplex&, double, const Progress&) { return std::nullopt; }

#endif

}  // namespace odontoscope::elements
