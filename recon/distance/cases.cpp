#include "recon/distance/cases.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <string_view>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

constexpr int corners = 8;
constexpr CaseNumber all_inside = 255;

CellEdge edge_between(int a, int b) {
  const int axis = std::countr_zero(static_cast<unsigned>(a ^ b));
  const int u = std::min(a, b) >> ((axis + 1) % 3) & 1, v = std::min(a, b) >> ((axis + 2) % 3) & 1;
  return static_cast<CellEdge>(4 * axis + 2 * v + u);
}

// --- base cases ------------------------------------------------------------------------------------------------------

/// Corners inside, and the polygons of the surface: each a list of cell edges, written as their two corners, that is
/// triangulated as a fan from its first. No side of these triangles lies in a face but the polygons' own.
struct BaseCase {
  int number;
  std::string_view inside;
  std::vector<std::string_view> polygons;
};

/// Inside corners of an ambiguous face are apart throughout.
const std::vector<BaseCase>& base_cases() {
  static const std::vector<BaseCase> all{
      {0, "", {}},
      {1, "0", {"01 02 04"}},
      {2, "01", {"02 04 15 13"}},
      {3, "03", {"01 02 04", "13 37 23"}},
      {4, "07", {"01 02 04", "37 57 67"}},
      {5, "012", {"04 15 13 23 26"}},
      {6, "017", {"02 04 15 13", "37 57 67"}},
      {7, "124", {"01 15 13", "02 23 26", "04 46 45"}},
      {8, "0123", {"04 15 37 26"}},
      {9, "0124", {"13 23 26 46 45 15"}},
      {10, "0167", {"02 04 15 13", "26 37 57 46"}},
      {11, "0137", {"02 04 15 57 67 23"}},
      {12, "0127", {"04 15 13 23 26", "37 57 67"}},
      {13, "0356", {"01 02 04", "13 37 23", "15 45 57", "26 67 46"}},
      {14, "0237", {"01 13 57 67 26 04"}},
  };
  return all;
}

/// Complements of 3, 6 and 7 that keep to the same rule; named by what they are complements of.
const std::vector<BaseCase>& modified_complements() {
  static const std::vector<BaseCase> all{
      {3, "124567", {"04 02 23 37 13 01"}},
      {6, "23456", {"02 13 37 67 57 15 04"}},
      {7, "03567", {"01 02 04", "13 15 45 46 26 23"}},
  };
  return all;
}

CaseNumber inside_of(const BaseCase& base) {
  int bits = 0;
  for (const char corner : base.inside) bits |= 1 << (corner - '0');
  return static_cast<CaseNumber>(bits);
}

CellTriangles triangles_of(const BaseCase& base) {
  CellTriangles cell;
  cell.base = static_cast<std::uint8_t>(base.number);
  for (const std::string_view polygon : base.polygons) {
    std::vector<CellEdge> edges;
    for (std::size_t at = 0; at < polygon.size(); at += 3)
      edges.push_back(edge_between(polygon[at] - '0', polygon[at + 1] - '0'));
    for (std::size_t i = 1; i + 1 < edges.size(); ++i) cell.edges.at(cell.count++) = {edges[0], edges[i], edges[i + 1]};
  }
  return cell;
}

// --- rotations -------------------------------------------------------------------------------------------------------

using CornerMap = std::array<int, corners>;

/// The 24 ways to turn a cube: where each corner goes.
std::vector<CornerMap> rotations() {
  std::vector<CornerMap> all;
  std::array<int, 3> axes{0, 1, 2};
  do {
    const bool even = axes[(std::find(axes.begin(), axes.end(), 0) - axes.begin() + 1) % 3] == 1;
    for (int mirrored = 0; mirrored < corners; ++mirrored) {
      const bool keeps_hand = even == (std::popcount(static_cast<unsigned>(mirrored)) % 2 == 0);
      if (!keeps_hand) continue;
      CornerMap map{};
      for (int corner = 0; corner < corners; ++corner) {
        int image = mirrored;
        for (int axis = 0; axis < 3; ++axis) image ^= (corner >> axis & 1) << axes[axis];
        map[corner] = image;
      }
      all.push_back(map);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return all;
}

CaseNumber turned(CaseNumber cell, const CornerMap& map) {
  int image = 0;
  for (int corner = 0; corner < corners; ++corner) image |= (cell >> corner & 1) << map[corner];
  return static_cast<CaseNumber>(image);
}

CellTriangles turned(CellTriangles cell, const CornerMap& map) {
  for (std::uint8_t t = 0; t < cell.count; ++t) {
    for (CellEdge& edge : cell.edges[t]) {
      const auto [low, high] = corners_of(edge);
      edge = edge_between(map[low], map[high]);
    }
  }
  return cell;
}

CellTriangles turned_over(CellTriangles cell) {
  for (std::uint8_t t = 0; t < cell.count; ++t) std::swap(cell.edges[t][1], cell.edges[t][2]);
  return cell;
}

/// The case as an image of one of `bases` by the first rotation that will do.
std::optional<CellTriangles> found_in(const std::vector<BaseCase>& bases, CaseNumber cell) {
  static const std::vector<CornerMap> turns = rotations();
  for (const BaseCase& base : bases) {
    for (const CornerMap& turn : turns) {
      if (turned(inside_of(base), turn) == cell) return turned(triangles_of(base), turn);
    }
  }
  return std::nullopt;
}

CellTriangles make_case(CaseTable table, CaseNumber cell) {
  if (const auto direct = found_in(base_cases(), cell)) return *direct;
  if (table == CaseTable::consistent) {
    if (auto modified = found_in(modified_complements(), cell)) {
      modified->complement = true;
      return *modified;
    }
  }
  auto complement = found_in(base_cases(), static_cast<CaseNumber>(all_inside ^ cell));
  if (!complement) throw InternalError("a case of marching cubes follows from no base case");
  if (table != CaseTable::classic_unoriented) complement = turned_over(*complement);
  complement->complement = true;
  return *complement;
}

std::array<CellTriangles, 256> make_table(CaseTable table) {
  std::array<CellTriangles, 256> cells;
  for (int cell = 0; cell <= all_inside; ++cell) cells[cell] = make_case(table, static_cast<CaseNumber>(cell));
  return cells;
}

}  // namespace

const std::array<CellTriangles, 256>& cell_triangles(CaseTable table) {
  static const std::array<std::array<CellTriangles, 256>, 3> tables{
      make_table(CaseTable::classic), make_table(CaseTable::classic_unoriented), make_table(CaseTable::consistent)};
  return tables[static_cast<std::size_t>(table)];
}

std::array<int, 2> corners_of(CellEdge edge) {
  const int axis = edge / 4, u = edge & 1, v = edge >> 1 & 1;
  const int low = u << ((axis + 1) % 3) | v << ((axis + 2) % 3);
  return {low, low | 1 << axis};
}

std::array<CellEdge, 4> edges_of(CellFace face) {
  const int axis = face / 2, side = face % 2, along_u = (axis + 1) % 3, along_v = (axis + 2) % 3;
  const int base = side << axis;
  const auto edge = [](int from, int along) { return edge_between(from, from | 1 << along); };
  return {edge(base, along_u), edge(base | 1 << along_v, along_u), edge(base, along_v),
          edge(base | 1 << along_u, along_v)};
}

std::vector<FaceSegment> face_segments(const CellTriangles& cell, CellFace face) {
  const auto edges = edges_of(face);
  std::vector<FaceSegment> segments;
  for (const auto& triangle : cell.triangles()) {
    for (int i = 0; i < 3; ++i) {
      const auto from = std::find(edges.begin(), edges.end(), triangle[i]);
      const auto to = std::find(edges.begin(), edges.end(), triangle[(i + 1) % 3]);
      if (from == edges.end() || to == edges.end()) continue;
      segments.push_back(
          {static_cast<std::uint8_t>(from - edges.begin()), static_cast<std::uint8_t>(to - edges.begin())});
    }
  }
  return segments;
}

FaceMeeting meeting(CaseTable table, CaseNumber first, CaseNumber second, int axis) {
  const auto& cells = cell_triangles(table);
  const std::vector<FaceSegment> here = face_segments(cells[first], static_cast<CellFace>(2 * axis + 1));
  std::vector<FaceSegment> there = face_segments(cells[second], static_cast<CellFace>(2 * axis));
  FaceMeeting result;
  for (const FaceSegment& segment : here) {
    const FaceSegment reversed{segment.to, segment.from};
    if (const auto partner = std::find(there.begin(), there.end(), reversed); partner != there.end()) {
      there.erase(partner);
    } else if (const auto same = std::find(there.begin(), there.end(), segment); same != there.end()) {
      there.erase(same);
      result.misoriented.push_back(segment);
    } else {
      result.unmatched.push_back(segment);
    }
  }
  result.unmatched.insert(result.unmatched.end(), there.begin(), there.end());
  return result;
}

bool is_ambiguous(CaseNumber cell, CellFace face) {
  const int axis = face / 2, side = face % 2;
  const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), base = side << axis;
  const auto inside = [cell](int corner) { return (cell >> corner & 1) != 0; };
  return inside(base) == inside(base | u | v) && inside(base | u) == inside(base | v) &&
         inside(base) != inside(base | u);
}

}  // namespace odontoscope
