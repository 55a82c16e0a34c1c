#include "recon/cavity/roots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "recon/core/polygon.h"
#include "recon/mesh/plane_section.h"

namespace odontoscope::cavity {

std::optional<Point2> passes(const CentreLine& line, double z) {
  for (std::size_t i = line.points.size() - 1; i > line.orifice; --i) {
    const Point3 &a = line.points[i - 1].at, &b = line.points[i].at;
    if ((a.z >= z) == (b.z >= z)) continue;
    const double share = (z - a.z) / (b.z - a.z);
    return Point2{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  }
  return std::nullopt;
}

std::size_t loop_round(const std::vector<Polygon>& loops, const std::optional<Point2>& place) {
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (place && encloses(loops[i], *place)) return i;
  return loops.size();
}

namespace {

/// Heights at which a root's canals are counted.
constexpr std::size_t root_sections = 120;

std::string vertucci_type(const std::vector<std::size_t>& sections) {
  constexpr std::array<const char*, 8> names = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  const std::array<std::vector<std::size_t>, 8> types = {
      {{1}, {2, 1}, {1, 2, 1}, {2}, {1, 2}, {2, 1, 2}, {1, 2, 1, 2}, {3}}};
  const auto found = std::find(types.begin(), types.end(), sections);
  return found == types.end() ? "other" : names[static_cast<std::size_t>(found - types.begin())];
}

/// 1 where canals run down from their orifices, -1 where they run up: heights times this fall towards the apex.
double falling(double towards_end) { return towards_end > 0 ? -1 : 1; }

double fall_of(const MeasuredRoot& root, const std::vector<MeasuredCanal>& canals) {
  double towards_end = 0;
  for (const std::size_t c : root.canals) towards_end += canals[c].end.z - canals[c].orifice.z;
  return falling(towards_end);
}

/// Canals that are one here count once.
std::size_t sections_at(const std::vector<Polygon>& loops, const CentreLines& lines, const MeasuredRoot& root,
                        double z) {
  std::vector<std::size_t> section(root.canals.size());
  std::iota(section.begin(), section.end(), std::size_t{0});
  for (std::size_t a = 0; a < section.size(); ++a)
    for (std::size_t b = a + 1; b < section.size(); ++b)
      if (section[a] != section[b] &&
          is_one_section(loops, lines.canals[root.canals[a]], lines.canals[root.canals[b]], z))
        std::replace(section.begin(), section.end(), section[b], section[a]);
  std::sort(section.begin(), section.end());
  return static_cast<std::size_t>(std::unique(section.begin(), section.end()) - section.begin());
}

/// Counts from the lower orifice to the first blind end, in runs.
std::vector<std::size_t> counted_sections(const Cavity& cavity, const CentreLines& lines, const MeasuredRoot& root,
                                          const std::vector<MeasuredCanal>& canals) {
  const double sign = fall_of(root, canals);
  double top = std::numeric_limits<double>::infinity(), bottom = -top, width = 0;
  for (const std::size_t c : root.canals) {
    const double orifice = sign * canals[c].orifice.z, end = sign * canals[c].end.z;
    top = std::min(top, std::max(orifice, end));
    bottom = std::max(bottom, std::min(orifice, end));
    width = std::max(width, canals[c].mean_width);
  }
  top -= 0.5 * width;
  bottom += 0.5 * width;
  std::vector<std::pair<std::size_t, std::size_t>> runs;  // count, heights
  for (std::size_t i = 0; i < root_sections && top > bottom; ++i) {
    const double z = sign * (top - (static_cast<double>(i) + 0.5) / root_sections * (top - bottom));
    const std::vector<Polygon> loops = section_loops(cavity.wall, z);
    const std::size_t count = sections_at(loops, lines, root, z);
    if (runs.empty() || runs.back().first != count) runs.push_back({count, 0});
    ++runs.back().second;
  }
  std::vector<std::size_t> sections;
  for (const auto& [count, times] : runs) {
    const double tall = (top - bottom) * static_cast<double>(times) / root_sections;
    if (tall >= width && (sections.empty() || sections.back() != count)) sections.push_back(count);
  }
  if (sections.empty() && !runs.empty()) sections.push_back(runs.front().first);
  return sections;
}

/// Shorter branches that end, below an orifice, in the same outer contour as one of the root's canals.
std::size_t branches_beside(const CentreLines& lines, const SurfaceMesh& outside, const MeasuredRoot& root) {
  const auto beside = [&](const CentreLine& branch) {
    // A width before its end, for the canal beside it may end at about the same height.
    const auto before = std::find_if(branch.points.rbegin(), branch.points.rend(),
                                     [&](const CentrePoint& p) { return length(branch.end - p.at) > 2 * p.radius; });
    const Point3& at = before == branch.points.rend() ? branch.end : before->at;
    const std::vector<Polygon> loops = section_loops(outside, at.z);
    const std::size_t own = loop_round(loops, Point2{at.x, at.y});
    return own < loops.size() && std::any_of(root.canals.begin(), root.canals.end(), [&](std::size_t c) {
             return loop_round(loops, passes(lines.canals[c], at.z)) == own;
           });
  };
  return static_cast<std::size_t>(std::count_if(lines.others.begin(), lines.others.end(), beside));
}

}  // namespace

std::vector<MeasuredRoot> roots_of(const Cavity& cavity, const CentreLines& lines, const SurfaceMesh& outside,
                                   const std::vector<MeasuredCanal>& canals) {
  std::vector<std::size_t> root_of(canals.size());
  std::iota(root_of.begin(), root_of.end(), std::size_t{0});
  for (std::size_t a = 0; a < canals.size(); ++a) {
    for (std::size_t b = a + 1; b < canals.size(); ++b) {
      // Canals of one root end at about the same height; the middle of the apical half that both have.
      const double sign = falling(canals[a].end.z - canals[a].orifice.z + canals[b].end.z - canals[b].orifice.z);
      const double end = std::max(sign * canals[a].end.z, sign * canals[b].end.z),
                   orifice = std::min(sign * canals[a].orifice.z, sign * canals[b].orifice.z);
      const double z = sign * (end + 0.25 * (orifice - end));
      const std::vector<Polygon> loops = section_loops(outside, z);
      const std::size_t one = loop_round(loops, passes(lines.canals[a], z)),
                        other = loop_round(loops, passes(lines.canals[b], z));
      if (one == other && one < loops.size()) std::replace(root_of.begin(), root_of.end(), root_of[b], root_of[a]);
    }
  }
  std::vector<MeasuredRoot> roots;
  for (std::size_t first = 0; first < canals.size(); ++first) {
    MeasuredRoot root;
    for (std::size_t c = 0; c < canals.size(); ++c)
      if (root_of[c] == first) root.canals.push_back(c);
    if (root.canals.empty()) continue;
    root.sections = counted_sections(cavity, lines, root, canals);
    root.vertucci = vertucci_type(root.sections);
    root.isthmuses = isthmuses_of(cavity, lines, root.canals, fall_of(root, canals));
    root.uncounted = branches_beside(lines, outside, root);
    roots.push_back(std::move(root));
  }
  return roots;
}

}  // namespace odontoscope::cavity

namespace odontoscope {
namespace {

std::string digits(std::size_t number, const char* const (&glyphs)[10]) {
  std::string made;
  for (const char digit : std::to_string(number)) made += glyphs[digit - '0'];
  return made;
}

}  // namespace

std::string ahmed_code(const std::vector<MeasuredRoot>& roots) {
  static constexpr const char* above[10] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                            "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  static constexpr const char* below[10] = {"\u2080", "\u2081", "\u2082", "\u2083", "\u2084",
                                            "\u2085", "\u2086", "\u2087", "\u2088", "\u2089"};
  if (roots.empty()) return "";
  std::string code = digits(roots.size(), above) + "TN";
  for (std::size_t r = 0; r < roots.size(); ++r) {
    if (roots[r].sections.empty()) return "";  // too short to count
    if (roots.size() > 1) code += " R" + digits(r + 1, below);
    for (std::size_t i = 0; i < roots[r].sections.size(); ++i)
      code += (i > 0 ? "\u207b" : "") + digits(roots[r].sections[i], above);
  }
  return code;
}

}  // namespace odontoscope
