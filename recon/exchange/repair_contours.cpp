#include "recon/exchange/repair_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "recon/exchange/close_channels.h"
#include "recon/exchange/region_border.h"
#include "recon/exchange/repeated_contours.h"
#include "recon/input/planar_sweep.h"

namespace odontoscope {
namespace {

constexpr int most_rounds = 7;

/// Grain that coordinates are rounded to before a further round, as a share of the largest: rounded places of crossing
/// lie a unit in the last place beside a corner, where no cut would part them. Coarser from round to round.
constexpr double first_grain = 0x1p-44, coarser = 16;

void round_to_grain(std::vector<std::vector<Point2>>& polygons, double share) {
  double largest = 0;
  for (const std::vector<Point2>& polygon : polygons) {
    for (const Point2& p : polygon) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  const double grain = std::exp2(std::ceil(std::log2(largest * share)));
  if (!(grain > 0)) return;
  for (std::vector<Point2>& polygon : polygons) {
    for (Point2& p : polygon) p = {std::round(p.x / grain) * grain, std::round(p.y / grain) * grain};
  }
}

/// Numbers of a slice's contours, by structure in order of first appearance.
std::vector<std::vector<std::size_t>> by_structure(const Slice& slice) {
  std::map<std::string_view, std::size_t> number;
  std::vector<std::vector<std::size_t>> members;
  for (std::size_t c = 0; c < slice.contours.size(); ++c) {
    const auto [at, fresh] = number.try_emplace(slice.contours[c].structure, members.size());
    if (fresh) members.emplace_back();
    members[at->second].push_back(c);
  }
  return members;
}

std::string breach_in_words(const Breach& breach, bool of_one) {
  const std::string where = fmt::format("({:.6g}, {:.6g})", breach.at.x, breach.at.y);
  switch (breach.kind) {
    case Breach::Kind::repeated_point:
      return "passed twice through " + where;
    case Breach::Kind::touch:
      return of_one ? "touched itself at " + where : "touched another at " + where;
    case Breach::Kind::fold_back:
      return "ran back on itself at " + where;
    case Breach::Kind::crossing:
      return of_one ? "crossed itself at " + where : "crossed another at " + where;
  }
  return "met itself";
}

class SliceRepair {
 public:
  SliceRepair(const std::string& file, std::size_t number, const Slice& slice, const RepairOptions& options,
              std::vector<ContourChange>& changes)
      : slice_(slice), options_(options), changes_(changes), is_repeat_(slice.contours.size(), false) {
    place_.file = file;
    place_.slice = number;
    place_.z = slice.z;
    // Sections of surfaces may lie on each other; a contour that was drawn is exported twice at most by mistake.
    if (options.inside != Inside::odd) return;
    for (const std::size_t c : repeats_of_earlier(slice.contours)) is_repeat_[c] = true;
  }

  /// Contours that need no change stay in their order; those of a structure that does come in the place of its first.
  Slice repaired() {
    std::vector<std::vector<Contour>> in_place_of(slice_.contours.size());
    for (const std::vector<std::size_t>& members : by_structure(slice_)) repair(members, in_place_of);
    Slice result{slice_.z, {}};
    for (std::vector<Contour>& contours : in_place_of) {
      std::move(contours.begin(), contours.end(), std::back_inserter(result.contours));
    }
    return result;
  }

 private:
  void repair(const std::vector<std::size_t>& members, std::vector<std::vector<Contour>>& in_place_of) {
    std::vector<Contour> kept;
    std::vector<std::size_t> number;                        // that each had in the slice
    std::optional<std::pair<double, std::size_t>> channel;  // its width, and whose it is
    for (const std::size_t c : members) {
      if (is_repeat_[c]) {
        tell(slice_.contours[c].structure, "is there already, and went", c);
        continue;
      }
      Contour contour = without_repeats(c);
      if (contour.points.size() < 3 || collinear(contour.points)) {
        tell(contour.structure, "enclosed nothing and went", c);
        continue;
      }
      const std::optional<ClosedChannel> closed =
          options_.inside == Inside::odd ? close_channels(contour.points) : std::nullopt;
      if (closed) {
        contour.points = closed->points;
        if (!channel || closed->width > channel->first) channel = {closed->width, c};
      }
      kept.push_back(std::move(contour));
      number.push_back(c);
    }
    const std::optional<Breach> breach = breach_of(kept);
    if (!breach) {
      if (channel)
        tell(slice_.contours[channel->second].structure,
             fmt::format("a channel {:.3g} mm wide was closed", channel->first), channel->second);
      for (std::size_t i = 0; i < kept.size(); ++i) in_place_of[number[i]].push_back(std::move(kept[i]));
      return;
    }
    std::vector<Contour> border = border_of(kept);
    const std::string why = channel ? fmt::format("a channel {:.3g} mm wide was closed", channel->first)
                                    : breach_in_words(*breach, breach->contour == breach->other_contour);
    tell(slice_.contours[members.front()].structure,
         fmt::format("{}: {} contour{} became {}", why, kept.size(), kept.size() == 1 ? "" : "s", border.size()),
         channel ? channel->second : number[breach->contour]);
    in_place_of[members.front()] = std::move(border);
  }

  Contour without_repeats(std::size_t c) {
    Contour contour = slice_.contours[c];
    std::vector<Point2>& points = contour.points;
    const std::size_t before = points.size();
    points.erase(std::unique(points.begin(), points.end()), points.end());
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (points.size() != before) {
      const std::size_t gone = before - points.size();
      tell(contour.structure,
           fmt::format("{} point{} repeated {} and went", gone, gone == 1 ? "" : "s",
                       gone == 1 ? "its neighbour" : "their neighbours"),
           c);
    }
    return contour;
  }

  static std::optional<Breach> breach_of(const std::vector<Contour>& contours) {
    std::vector<std::size_t> all(contours.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return sweep(contours, all).breach;
  }

  std::vector<Contour> border_of(std::vector<Contour> contours) {
    const std::string structure = contours.front().structure;
    double grain = first_grain;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<std::vector<Point2>> polygons;
      for (const Contour& contour : contours) polygons.push_back(contour.points);
      if (round > 0) round_to_grain(polygons, std::exchange(grain, grain * coarser));
      contours.clear();
      for (std::vector<Point2>& polygon : region_border(polygons, options_)) {
        if (polygon.size() >= 3 && !collinear(polygon)) contours.push_back({structure, std::move(polygon)});
      }
      if (!breach_of(contours)) return contours;
    }
    throw InputError("beyond-repair", place_,
                     fmt::format("the contours of {} meet in a way that could not be untangled in {} rounds", structure,
                                 most_rounds),
                     "Draw them again in the program that made them");
  }

  void tell(const std::string& structure, std::string what, std::size_t contour) {
    Place place = place_;
    place.contour = contour;
    changes_.push_back({std::move(place), structure, std::move(what)});
  }

  const Slice& slice_;
  const RepairOptions& options_;
  std::vector<ContourChange>& changes_;
  std::vector<bool> is_repeat_;
  Place place_;
};

}  // namespace

RepairedContours repair_contours(const ContourStack& stack, const RepairOptions& options, const Progress& progress) {
  RepairedContours result;
  result.stack.source = stack.source;
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    progress.check();
    progress.tell("repair", static_cast<double>(s) / static_cast<double>(stack.slices.size()));
    result.stack.slices.push_back(SliceRepair(stack.source, s, stack.slices[s], options, result.changes).repaired());
  }
  return result;
}

std::string in_words(const ContourChange& change) {
  return fmt::format("{}, {}: {}", change.place.in_words(), change.structure, change.what);
}

}  // namespace odontoscope
