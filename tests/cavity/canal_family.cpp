#include "tests/cavity/canal_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/mesh/vector.h"
#include "tests/cavity/voids.h"

namespace odontoscope::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Sebastiano Vigna's SplitMix64: the same numbers everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  double between(double low, double high) {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

KnownRoot of_type(const std::string& type, Dice& dice) {
  const RootShape shape = root_of_type(type, dice.between(1.08, 1.25));
  const double tall = dice.between(0.9, 1.15), wide = dice.between(0.95, 1.2), radius = dice.between(0.22, 0.36);
  KnownRoot root{.kind = "type " + type, .vertucci = type, .sections = shape.sections};
  for (std::vector<Point3> axis : shape.canals) {
    for (Point3& p : axis) p = {wide * p.x, wide * p.y, tall * p.z};
    root.canals.push_back({axis, radius, radius});
  }
  root.chamber = dice.between(1.15, 1.45);
  root.alone = type == "I" || type == "IV" || type == "VIII";
  root.oval = type != "VIII" && dice.between(0, 1) < 0.5 ? dice.between(1.1, 1.8) : 1;
  if (type == "I") root.bend = infinite;
  return root;
}

KnownRoot straight(const std::string& kind, double above, double below, double deep) {
  return {.kind = kind,
          .vertucci = "I",
          .sections = {1},
          .canals = {{{{0, 0, 0}, {0, 0, -deep}}, above, below}},
          .bend = infinite,
          .alone = true};
}

/// Straight for a while, then round.
std::vector<Point3> arc_axis(double straight, double bend, double whole) {
  std::vector<Point3> axis{{0, 0, 0}, {0, 0, -straight}};
  constexpr int pieces = 120;
  for (int i = 1; i <= pieces; ++i) {
    const double turn = (whole - straight) * i / pieces / bend;
    axis.push_back({bend * (1 - std::cos(turn)), 0, -straight - bend * std::sin(turn)});
  }
  return axis;
}

KnownRoot arc_of(double bend, Dice& dice) {
  const double radius = dice.between(0.22, 0.36);
  KnownRoot root = straight(fmt::format("arc {} mm", bend), radius, radius, 1);
  const double above = dice.between(2, 4.5);
  root.canals[0].axis =
      arc_axis(above, bend, above + std::min(0.7 * bend, dice.between(7.5, 9.5)));  // within the block
  root.block = 4.2;
  root.bend = bend;
  root.oval = dice.between(0, 1) < 0.5 ? dice.between(1.1, 1.8) : 1;
  return root;
}

/// Two canals at x = -1 and 1, down to -11 and -10.5.
KnownRoot two(const std::string& kind, double radius) {
  KnownRoot root{.kind = kind, .vertucci = "IV", .sections = {2}};
  root.canals = {{{{0, 0, 0}, {-1, 0, -3}, {-1, 0, -11}}, radius, radius},
                 {{{0, 0, 0}, {1, 0, -3}, {1, 0, -10.5}}, radius, radius}};
  return root;
}

KnownRoot isthmus(const std::string& type, Dice& dice) {
  const double radius = dice.between(0.3, 0.38);
  KnownRoot root = two("isthmus " + type, radius);
  const double thick = type == "II" ? dice.between(0.1, 0.2) * 2 * radius : dice.between(0.45, 0.6) * 2 * radius;
  const double high = dice.between(-6, -5), low = dice.between(-9.2, -8.5);
  root.wing = Wing{thick, -1, type == "IV" ? dice.between(0.2, 0.35) : 1, low, high};
  root.isthmus = type;
  return root;
}

KnownRoot short_fork(Dice& dice) {
  const double radius = dice.between(0.17, 0.22), turn = dice.between(35, 42) * std::numbers::pi / 180,
               high = dice.between(9, 9.4);
  KnownRoot root{.kind = "short fork", .vertucci = "V", .sections = {1, 2}};
  const double far = dice.between(2.3, 2.5), main = high + dice.between(2.4, 2.7);
  root.canals = {{{{0, 0, 0}, {0, 0, -high}, {0, 0, -main}}, radius, radius},
                 {{{0, 0, 0}, {0, 0, -high}, {far * std::sin(turn), 0, -high - far * std::cos(turn)}}, radius, radius}};
  return root;
}

KnownRoot kind_of(std::uint64_t kind, Dice& dice) {
  static const std::array<std::string, 8> types = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  constexpr std::array<double, 3> bends = {8, 15, 30};
  if (kind < 8) return of_type(types[kind], dice);
  if (kind == 8) return straight("taper", dice.between(0.4, 0.5), dice.between(0.16, 0.25), dice.between(10, 13));
  if (kind < 12) return arc_of(bends[kind - 9], dice);
  if (kind == 12) {
    KnownRoot root = straight("open apex", dice.between(0.3, 0.4), dice.between(0.25, 0.3), 22);
    root.block_low = dice.between(-10, -8);
    return root;
  }
  if (kind == 13) {
    KnownRoot root = two("two tapers", 0.4);
    for (KnownCanal& canal : root.canals) {
      canal.radius_above = dice.between(0.38, 0.45);
      canal.radius_below = dice.between(0.18, 0.25);
    }
    root.alone = true;
    return root;
  }
  if (kind == 14) return short_fork(dice);
  if (kind == 15) {
    KnownRoot root = straight("fin", dice.between(0.35, 0.42), dice.between(0.3, 0.34), 11.5);
    root.wing = Wing{dice.between(0.25, 0.35), 0, dice.between(0.8, 1.2), -9, -6};
    root.alone = false;
    root.bend.reset();
    return root;
  }
  if (kind == 16) {
    KnownRoot root = straight("accessory canal", 0.4, 0.35, 11.5);
    const double z = dice.between(-9.5, -8.5);
    root.accessory = {{{0, 0, z}, {dice.between(1.7, 2.2), 0, z - dice.between(0.2, 0.6)}, dice.between(0.12, 0.16)}};
    root.alone = false;
    root.bend.reset();
    return root;
  }
  if (kind < 20) return isthmus(kind == 17 ? "V" : kind == 18 ? "II" : "IV", dice);
  KnownRoot root = straight("ribbon", dice.between(0.25, 0.35), dice.between(0.2, 0.25), 11);
  root.oval = dice.between(2.2, 3);
  root.chamber = 1.15;
  root.block = 4.2;
  return root;
}

/// Straight, an arc, straight again.
std::vector<Point3> part_arc(double above, double bend, double turn, double below) {
  std::vector<Point3> axis = arc_axis(above, bend, above + bend * turn);
  const Point3 last = axis.back();
  axis.push_back({last.x + below * std::sin(turn), 0, last.z - below * std::cos(turn)});
  return axis;
}

/// An arc to one side and one of another radius to the other.
std::vector<Point3> double_curve(double above, double first, double second, double turn) {
  std::vector<Point3> axis = arc_axis(above, first, above + first * turn);
  const Point3 from = axis.back();
  constexpr int pieces = 120;
  for (int i = 1; i <= pieces; ++i) {
    const double gone = 1.6 * turn * i / pieces;  // beyond upright again
    axis.push_back({from.x + second * (std::cos(turn - gone) - std::cos(turn)), 0,
                    from.z - second * (std::sin(turn) - std::sin(turn - gone))});
  }
  return axis;
}

KnownRoot bent(const std::string& kind, double bend, std::vector<Point3> axis, double radius) {
  KnownRoot root = straight(fmt::format("{} {} mm", kind, bend), radius, radius, 1);
  root.canals[0].axis = std::move(axis);
  root.block = 4.4;
  root.bend = bend;
  return root;
}

KnownRoot three_in_a_row(Dice& dice) {
  const double radius = dice.between(0.28, 0.34);
  KnownRoot root{.kind = "isthmus III", .vertucci = "VIII", .sections = {3}};
  root.canals = {{{{0, 0, 0}, {0, 0, -11}}, radius, radius},
                 {{{0, 0, 0}, {-1.3, 0, -3}, {-1.3, 0, -11}}, radius, radius},
                 {{{0, 0, 0}, {1.3, 0, -3}, {1.3, 0, -10.8}}, radius, radius}};
  root.wing = Wing{dice.between(0.12, 0.2) * 2 * radius, -1.3, 1.3, dice.between(-9.2, -8.5), dice.between(-6, -5)};
  root.isthmus = "III";
  return root;
}

KnownRoot rare_kind(std::uint64_t kind, double bend, Dice& dice) {
  const double radius = dice.between(0.22, 0.36), above = dice.between(2.5, 4),
               turn = std::min(dice.between(3.5, 5) / bend, 0.5);
  const double whole = above + std::min(0.7 * bend, dice.between(7, 8.5));
  KnownRoot root;
  switch (kind) {
    case 0:
      root = bent("arc, wide to where it bends,", bend, arc_axis(above, bend, whole), radius);
      root.canals[0].aside = dice.between(1.3, 2);
      return root;
    case 1:
      return bent("part of an arc", bend, part_arc(above, bend, turn, dice.between(2.5, 3.5)), radius);
    case 2:
      root = bent("tapering arc", bend, arc_axis(above, bend, whole), radius);
      root.canals[0].radius_above = dice.between(0.38, 0.45);
      root.canals[0].radius_below = dice.between(0.15, 0.2);
      root.oval = dice.between(1, 1.8);
      return root;
    case 3:
      return bent("double curve", bend, double_curve(2.5, 1.25 * bend, bend, std::min(0.6, 4.5 / bend)), radius);
    case 4:  // out at the root's side
      root = bent("to the side", 4, arc_axis(dice.between(5, 6), 4, 12), radius);
      root.block = 2;
      return root;
    case 5:
      root = straight("blunderbuss", 0.3, dice.between(0.7, 0.9), 12);
      root.block_low = dice.between(-8, -6.5);
      return root;
    case 6:
      root = straight("gutter", 0.2, 0.2, 1);
      root.canals[0].axis = {{0, 0, 0}, {1, 0, 0}, {1, 0, -11}};
      root.canals[0].radius_above = root.canals[0].radius_below = dice.between(0.15, 0.25);
      root.gutter = Gutter{1, 2 * root.canals[0].radius_above, dice.between(70, 130), -11};
      root.chamber = 1.35;
      root.alone = false;
      return root;
    case 7: {
      root = straight("delta", 0.35, 0.3, 11.5);
      const double high = dice.between(9.6, 10.1), turned = dice.between(0, 1);
      for (int i = 0; i < 3; ++i) {
        const double angle = turned + 2 * std::numbers::pi * i / 3, far = dice.between(1.3, 1.6);
        root.accessory.push_back({{0, 0, -high},
                                  {far * std::cos(angle), far * std::sin(angle), -high - dice.between(0.7, 1.1)},
                                  dice.between(0.1, 0.13)});
      }
      root.alone = false;
      return root;
    }
    case 8:
      root = bent("flat, part of an arc", bend, part_arc(above, bend, turn, 3), radius);
      root.oval = dice.between(2, 2.5);
      root.chamber = 1.15;
      return root;
    case 9:
      root = straight("straight oval taper", dice.between(0.35, 0.42), dice.between(0.16, 0.22), 11);
      root.canals[0].aside = dice.between(1.3, 2);
      return root;
    case 10:
      root = bent("flat arc", bend, arc_axis(above, bend, whole), radius);
      root.oval = dice.between(2, 2.8);
      root.chamber = 1.15;
      return root;
    default:
      return three_in_a_row(dice);
  }
}

std::string counts_of(const Anatomy& made) {
  std::string told =
      made.roots.size() == 1 ? made.roots[0].vertucci + " [" : fmt::format("{} roots [", made.roots.size());
  for (const MeasuredRoot& one : made.roots)
    for (const std::size_t n : one.sections) told += fmt::format(" {}", n);
  told += fmt::format(" ], {} canals, {} horns, {} branches, {} accessory", made.canals.size(), made.horns,
                      made.other_branches, made.accessory_canals.size());
  for (const MeasuredRoot& one : made.roots)
    for (const Isthmus& way : one.isthmuses)
      told += fmt::format(", isthmus {} {:.2f}-{:.2f}", way.type, way.from_apex, way.to_apex);
  return told;
}

/// Also that no other is told.
bool beside_right(const KnownRoot& root, const Anatomy& made) {
  if (made.accessory_canals.size() != root.accessory.size() || made.roots.size() != 1) return false;
  if (std::any_of(made.accessory_canals.begin(), made.accessory_canals.end(),
                  [](const AccessoryCanal& one) { return one.third != 2; }))
    return false;
  const std::vector<Isthmus>& told = made.roots[0].isthmuses;
  if (root.isthmus.empty()) return told.empty();
  if (told.empty() ||
      std::any_of(told.begin(), told.end(), [&](const Isthmus& one) { return one.type != root.isthmus; }))
    return false;
  if (root.isthmus != "III" && told.size() != 1)
    return false;  // among three canals one is told for each two that it joins
  const double apex = 11 + root.canals[0].radius_below;
  return std::abs(told[0].from_apex - apex - root.wing->low) < 0.4 &&
         std::abs(told[0].to_apex - apex - root.wing->high) < 0.4;
}

/// Of the known axis from the line that was found.
double mean_distance(const KnownRoot& root, const KnownCanal& canal, const CentreLine& line) {
  double sum = 0;
  for (const Point3& own : canal.axis) {
    const Point3 p = as_it_lies(root, own);
    double nearest = infinite;
    for (const CentrePoint& one : line.points) nearest = std::min(nearest, length(one.at - p));
    sum += nearest / static_cast<double>(canal.axis.size());
  }
  return sum;
}

void judge_canal(const KnownRoot& root, const KnownFigures& known, const MeasuredCanal& canal, const CanalShape& shape,
                 const CanalUncertainty& off, FamilyVerdict& verdict) {
  const auto tell = [&](const std::string& name, double is, double told, double may) {
    verdict.figures.push_back({name, is, told, may});
  };
  tell("length", known.length, canal.length, off.length);
  tell("narrowest width", known.narrowest, canal.narrowest ? canal.narrowest->width : canal.mean_width, off.narrowest);
  verdict.orifice_off = std::max(verdict.orifice_off, length(canal.orifice - known.orifice));
  if (known.thinnest_wall > 0 && canal.thinnest_wall && root.accessory.empty() && !root.wing && !root.gutter)
    tell("thinnest wall", known.thinnest_wall, canal.thinnest_wall->width, off.thinnest_wall);
  if (!root.alone) return;
  tell("mean width", known.mean_width, canal.mean_width, off.mean_width);
  if (known.schneider_deg > 5) tell("Schneider's angle", known.schneider_deg, canal.schneider_deg, off.schneider_deg);
  for (std::size_t i = 0; i < shape.apical.size(); ++i) {
    tell("apical width", known.apical_width[i], shape.apical[i].width, off.apical_width[i]);
    tell("apical area", known.apical_area[i], shape.apical[i].area, off.apical_area[i]);
  }
  for (std::size_t third = 0; third < 3; ++third) {
    tell("volume of a third", known.third_volume[third], shape.thirds[third].volume, off.volume[third]);
    tell("area of a third", known.third_area[third], shape.thirds[third].area, off.area[third]);
  }
  if (!root.bend) return;
  if (std::isfinite(*root.bend)) {
    tell(fmt::format("bend {:>2} mm", *root.bend), *root.bend, canal.smallest_bend, off.smallest_bend);
  } else {
    tell("straight", 1, std::isfinite(canal.smallest_bend) ? canal.smallest_bend : 1, 0);
  }
}

}  // namespace

KnownRoot random_root(std::uint64_t seed) {
  Dice dice(seed);
  KnownRoot root = kind_of(seed % kinds_of_roots, dice);
  if (dice.between(0, 3) > 1) {
    root.spin_deg = dice.between(0, 360);
    root.tilt_deg = dice.between(0, 30);
  }
  return root;
}

KnownRoot rare_root(std::uint64_t seed) {
  constexpr std::array<double, 3> bends = {8, 15, 30};
  Dice dice(seed);
  KnownRoot root = rare_kind(seed % rare_kinds, bends[seed / rare_kinds % bends.size()], dice);
  if (dice.between(0, 3) > 1) {
    root.spin_deg = dice.between(0, 360);
    root.tilt_deg = dice.between(0, 30);
  }
  return root;
}

FamilyVerdict judge(const KnownRoot& root, const Anatomy& made) {
  FamilyVerdict verdict;
  verdict.counted = made.roots.size() == 1 && made.canals.size() == root.canals.size() &&
                    made.roots[0].vertucci == root.vertucci && made.roots[0].sections == root.sections;
  verdict.beside = beside_right(root, made);
  verdict.told =
      fmt::format("{}, oval {:.2f}, tilt {:.0f}: told {}", root.kind, root.oval, root.tilt_deg, counts_of(made));
  for (const MeasuredCanal& canal : made.canals)
    if (!verdict.counted)
      verdict.told +=
          fmt::format(", {} {:.2f} long from {:.2f} {:.2f} {:.2f} to {:.2f} {:.2f} {:.2f}", canal.name, canal.length,
                      canal.orifice.x, canal.orifice.y, canal.orifice.z, canal.end.x, canal.end.y, canal.end.z);
  if (made.canals.size() != root.canals.size()) return verdict;
  std::vector<std::size_t> left(made.canals.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<KnownFigures> known;
  for (const KnownCanal& canal : root.canals) known.push_back(figures_of(root, canal));
  for (std::size_t c = 0; c < known.size(); ++c) {
    const auto away = [&](std::size_t m) { return mean_distance(root, root.canals[c], made.lines.canals[m]); };
    const auto own =
        std::min_element(left.begin(), left.end(), [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
    judge_canal(root, known[c], made.canals[*own], made.shapes[*own], made.uncertainties[*own], verdict);
    left.erase(own);
  }
  return verdict;
}

Anatomy anatomy_of(const Reconstruction& model) {
  std::vector<StructureSurface> parts;
  for (const Solid& solid : model.solids) parts.push_back({solid.structure, &solid.surface});
  return measure_anatomy(parts, {}, model.counts.slices);
}

}  // namespace odontoscope::test
