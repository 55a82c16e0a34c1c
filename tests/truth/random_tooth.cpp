#include "random_tooth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "../support/random_numbers.h"
#include "recon/core/embedded_file.h"
#include "recon/core/error.h"
#include "recon/sample/tooth_field.h"
#include "recon/sample/tooth_table.h"

namespace odontoscope {

std::span<const EmbeddedFile> drawn_teeth();  // tests/truth/teeth, made part of the program

}  // namespace odontoscope

namespace odontoscope::test {
namespace {

using namespace sample;
using std::numbers::pi;

constexpr double least_wall = 0.25, least_roof = 0.3, least_canal = 0.13;  // mm
constexpr double cervix = 14;                                              // about, in all three sample teeth
constexpr std::uint64_t attempt_stride = 0x51ab'7e0d'9e37'79b9;            // parts the attempts of one seed

template <class Change>
Profile changed(const Profile& profile, Change change) {
  std::vector<Profile::Knot> knots = profile.knots();
  for (Profile::Knot& knot : knots) knot = change(knot);
  return Profile(std::move(knots));
}

Profile scaled(const Profile& profile, double factor) {
  return changed(profile, [factor](Profile::Knot k) { return Profile::Knot{k.at, k.value * factor}; });
}

/// What a drawing begins with: tables of the family's own, so that its teeth stay as they are when a sample tooth
/// changes.
ToothShape drawn_tooth(ToothKind kind) {
  const std::string file = std::string(name(kind)) + ".json";
  for (const EmbeddedFile& table : drawn_teeth())
    if (table.name == file) return read_tooth_table(table.bytes, file);
  throw InternalError("no table of a " + std::string(name(kind)));
}

/// Draws one tooth; whether it keeps the walls that it must is looked at afterwards.
class Drawing {
 public:
  explicit Drawing(std::uint64_t seed) : random_(seed) {}

  ToothShape shape() {
    const double kind = random_.unit();
    if (kind < 0.45) {
      draw_molar();
    } else if (kind < 0.75) {
      draw_premolar();
    } else {
      draw_incisor();
    }
    vary_crown();
    vary_chamber();
    vary_horns();
    add_accessory_canals();
    return shape_;
  }

  Pose pose() {
    const double size = random_.between(0.85, 1.1);
    Pose pose;
    for (double& stretch : pose.stretch) stretch = size * random_.between(0.93, 1.07);
    pose.spin = random_.between(-pi, pi);
    pose.tilt = random_.between(0, 30) * pi / 180;
    return pose;
  }
  double first_slice() { return random_.between(0.1, 0.9); }

  /// From the chamber's floor straight down into the furcation, where there is one.
  void add_furcation_canal(ToothShape& shape) {
    if (shape.roots.size() < 2 || !random_.chance(0.2)) return;
    const PulpChamber& box = shape.chamber;
    const double x = (box.low.x + box.high.x) / 2 + random_.between(-0.4, 0.4);
    const double y = (box.low.y + box.high.y) / 2 + random_.between(-0.4, 0.4);
    const double radius = random_.between(0.13, 0.2), start = box.low.z + 0.3;
    for (double length = 0.5; length < 6; length += 0.1) {
      if (ToothSection(shape, start - length).hard_tissue({far_above, far_above}, {x, y}).tooth < 0.4) continue;
      shape.accessory_canals.push_back({"furcation", {x, y, start}, {x, y, start - length}, radius, radius});
      break;
    }
  }

 private:
  double about(double share) { return random_.between(1 - share, 1 + share); }

  // --- roots and canals ---

  /// Stretches what lies below the cervix: the furcation goes from `from` to `to`, the apices down by `longer`.
  void move_furcation(double from, double to, double longer) {
    const auto moved = [=](double z) {
      if (z >= cervix) return z;
      if (z >= from) return cervix - (cervix - z) * (cervix - to) / (cervix - from);
      return to - (from - z) * (to + longer) / from;
    };
    const auto move = [&](Profile& profile) {
      if (profile.knots().size() > 1)
        profile = changed(profile, [&](Profile::Knot k) { return Profile::Knot{moved(k.at), k.value}; });
    };
    for (Root& root : shape_.roots) {
      root.apex_z = moved(root.apex_z);
      for (Profile* p : {&root.x, &root.y, &root.half_mesiodistal, &root.half_buccolingual, &root.lobe_offset})
        move(*p);
    }
    for (Canal& canal : shape_.canals)
      for (Profile* p : {&canal.half_mesiodistal, &canal.half_buccolingual}) move(*p);
    shape_.trunk_low_z = moved(shape_.trunk_low_z);
  }

  /// Bends a root's axis: its apex goes sideways by `apex`, its middle by `middle`.
  static Profile bent(const Profile& axis, double apex_z, double apex, double middle) {
    const double length = cervix - apex_z;
    std::vector<Profile::Knot> knots;
    for (const double share : {0.0, 0.15, 0.35, 0.6, 0.85, 1.0}) {
      const double low = (1 - share) * (1 - share), swing = share * (1 - share) * 4;
      const double z = apex_z + share * length;
      knots.push_back({z, axis(z) + apex * low + middle * swing * (1 - share)});
    }
    return Profile(std::move(knots));
  }

  void bend_roots(double most) {
    for (Root& root : shape_.roots) {
      root.x = bent(root.x, root.apex_z, random_.between(-most, most), random_.between(-most, most) / 2);
      root.y = bent(root.y, root.apex_z, random_.between(-most, most), random_.between(-most, most) / 2);
      const double taper = about(0.1);
      root.half_mesiodistal = scaled(root.half_mesiodistal, taper * about(0.05));
      root.half_buccolingual = scaled(root.half_buccolingual, taper * about(0.05));
      root.blunt *= about(0.25);
    }
  }

  Canal canal(std::string name, std::size_t root, double wide_at_apex, double wide_at_orifice, double flat) {
    const double low = shape_.roots[root].apex_z;
    const auto profile = [&](double factor) {
      return Profile({{low + 0.5, std::max(least_canal, wide_at_apex * factor)},
                      {low + 4, std::max(least_canal, (0.7 * wide_at_apex + 0.3 * wide_at_orifice) * factor)},
                      {12.5, std::max(least_canal, wide_at_orifice * factor)}});
    };
    return {.name = std::move(name), .root = root, .half_mesiodistal = profile(1), .half_buccolingual = profile(flat)};
  }

  /// One canal, or two that run apart, join at the apex, or part and join again (Vertucci's types I, IV, II and III).
  void add_canals(std::size_t root, double wide, double reach, bool two) {
    const double low = shape_.roots[root].apex_z, apex = random_.between(0.14, 0.24), top = shape_.canal_top_z;
    const double flat = two ? 1.0 : random_.between(1.0, 1.9);
    const int type = two ? random_.whole(2, 4) : 1;
    for (const double side : {-1.0, 1.0}) {
      if (!two && side > 0) break;
      Canal added = canal(side < 0 ? "first" : "second", root, apex, wide * about(0.2), flat);
      if (two) {
        const double below = type == 4 ? reach * 0.7 : 0.0, above = type == 3 ? 0.0 : reach;
        added.shift_y = Profile({{low + 1.5, side * below},
                                 {low + 3.5, side * (type == 4 ? below : 0.9 * reach)},
                                 {(low + top) / 2, side * reach},
                                 {top - 2.5, side * (type == 3 ? reach * 0.8 : above)},
                                 {top, side * above}});
      }
      shape_.canals.push_back(std::move(added));
    }
    const bool open = random_.chance(0.4);
    for (Canal& added : shape_.canals)
      if (added.root == root) added.open = open;
  }

  /// A root that leaves the crown in the direction (cx, cy) from its middle.
  Root free_root(std::string name, double cx, double cy, double half, double furcation) {
    const double spread = random_.between(1.15, 1.9), curl = random_.between(0.75, 1.1), apex = random_.between(0, 2.5);
    const auto axis = [&](double c) {
      return Profile({{apex, c * spread * curl},
                      {apex + 0.45 * (furcation - apex), c * spread},
                      {furcation, 1.06 * c},
                      {cervix, c}});
    };
    const auto width = [&](double factor) {
      return Profile({{apex, 0.5 * half * factor},
                      {apex + 0.35 * (furcation - apex), 0.78 * half * factor},
                      {furcation - 0.5, half * factor},
                      {cervix, 1.15 * half * factor}});
    };
    return {.name = std::move(name),
            .apex_z = apex,
            .blunt = random_.between(1.1, 1.8),
            .x = axis(cx),
            .y = axis(cy),
            .half_mesiodistal = width(1),
            .half_buccolingual = width(about(0.15)),
            .lobe_offset = 0.0,
            .exponent = random_.between(2.0, 2.3)};
  }

  void draw_molar() {
    shape_ = drawn_tooth(ToothKind::molar);
    const int roots = std::array{1, 2, 2, 2, 3, 3, 4}[static_cast<std::size_t>(random_.below(7))];
    const double furcation = random_.between(8.5, 11.8);
    if (roots == 2) {
      move_furcation(11, furcation, random_.between(-0.5, 0.8));
      bend_roots(0.35);
      for (Root& root : shape_.roots) root.lobe_offset = scaled(root.lobe_offset, about(0.12));
      if (random_.chance(0.5)) {
        for (Canal& old : shape_.canals) vary_width(old);
        return;
      }
      shape_.canals.clear();
      add_canals(0, random_.between(0.35, 0.55), random_.between(0.9, 1.4), true);
      add_canals(1, random_.between(0.4, 0.65), random_.between(0.8, 1.3), random_.chance(0.5));
      return;
    }
    shape_.roots.clear();
    shape_.canals.clear();
    if (roots == 1) {
      draw_single_root(3.9, 3.8, random_.between(0.8, 1.2), 0.6);
      return;
    }
    struct Foot {
      const char* name;
      double x, y, half;
    };
    const std::vector<Foot> three{
        {"mesiobuccal", 2.2, 2.0, 2.0}, {"distobuccal", -2.2, 1.9, 1.9}, {"lingual", 0, -2.3, 2.2}};
    const std::vector<Foot> four{{"mesiobuccal", 2.3, 2.2, 1.9},
                                 {"distobuccal", -2.3, 2.1, 1.9},
                                 {"mesiolingual", 2.2, -2.2, 1.9},
                                 {"distolingual", -2.2, -2.2, 1.9}};
    for (const Foot& foot : roots == 3 ? three : four) {
      shape_.roots.push_back(free_root(foot.name, foot.x, foot.y, foot.half, furcation));
      add_canals(shape_.roots.size() - 1, random_.between(0.3, 0.5), 0.5, random_.chance(0.2));
    }
    shape_.root_blend = random_.between(0.6, 1.3);
    shape_.trunk_low_z = std::min(12.5, furcation + random_.between(0.5, 1.5));
  }

  void draw_single_root(double mesiodistal, double buccolingual, double wide, double reach) {
    const double apex = random_.between(0, 1.5);
    const auto width = [&](double half) {
      return Profile({{apex, 0.42 * half}, {4, 0.66 * half}, {9, 0.9 * half}, {11.5, 0.97 * half}, {cervix, half}});
    };
    shape_.roots = {{.name = "root",
                     .apex_z = apex,
                     .blunt = random_.between(1.4, 2.2),
                     .x = {{0, random_.between(-0.6, 0.6)}, {4, random_.between(-0.2, 0.2)}, {9, 0.0}, {cervix, 0.0}},
                     .y = {{0, random_.between(-0.4, 0.4)}, {5, random_.between(-0.2, 0.2)}, {cervix, 0.0}},
                     .half_mesiodistal = width(mesiodistal),
                     .half_buccolingual = width(buccolingual),
                     .lobe_offset = 0.0,
                     .exponent = random_.between(2.0, 2.3)}};
    add_canals(0, wide, reach, random_.chance(0.4));
  }

  void draw_premolar() {
    shape_ = drawn_tooth(ToothKind::premolar);
    const bool two_roots = random_.chance(0.6);
    if (two_roots) {
      move_furcation(7, random_.between(4.5, 9.5), random_.between(-0.5, 0.8));
      bend_roots(0.25);
      for (Canal& old : shape_.canals) vary_width(old);
      return;
    }
    shape_.roots.clear();
    shape_.canals.clear();
    draw_single_root(2.4, 3.7, random_.between(0.35, 0.6), random_.between(0.9, 1.5));
  }

  void draw_incisor() {
    shape_ = drawn_tooth(ToothKind::incisor);
    bend_roots(0.4);
    if (random_.chance(0.3)) {
      shape_.canals.clear();
      add_canals(0, random_.between(0.45, 0.7), random_.between(0.55, 0.8), true);
    } else {
      for (Canal& old : shape_.canals) vary_width(old);
    }
  }

  void vary_width(Canal& canal) {
    const double factor = random_.between(0.75, 1.35);
    for (Profile* p : {&canal.half_mesiodistal, &canal.half_buccolingual}) {
      *p = changed(*p, [&](Profile::Knot k) { return Profile::Knot{k.at, std::max(least_canal, k.value * factor)}; });
    }
    if (canal.lobe == 0) canal.open = random_.chance(0.4);
  }

  // --- crown and pulp ---

  void vary_crown() {
    CervicalLine& line = shape_.cervical_line;
    line.z += random_.between(-0.4, 0.5);
    for (double* rise : {&line.rise_mesial, &line.rise_distal, &line.rise_lingual})
      *rise = std::max(0.0, *rise * about(0.4) + random_.between(-0.1, 0.3));
    Enamel& enamel = shape_.enamel;
    enamel.side *= about(0.25);
    enamel.side_height *= about(0.35);
    enamel.top *= about(0.15);
    enamel.margin_exponent = random_.between(0.6, 0.95);
    enamel.margin_height = random_.between(0.06, 0.25);
    Occlusal& occlusal = shape_.occlusal;
    if (occlusal.cusps.size() == 5 && random_.chance(0.3)) occlusal.cusps.erase(occlusal.cusps.begin() + 2);
    for (Cusp& cusp : occlusal.cusps) {
      cusp.tip.x += random_.between(-0.2, 0.2);
      cusp.tip.y += random_.between(-0.2, 0.2);
      cusp.tip.z += random_.between(-0.4, 0.2);
      cusp.slope_in *= about(0.2);
      cusp.slope_along *= about(0.2);
      cusp.rounding *= about(0.3);
    }
    if (!occlusal.cusps.empty()) {
      occlusal.fissure_depth = random_.between(0.1, 0.85);
      occlusal.fissure_width = random_.between(0.3, 0.6);
      occlusal.supplemental_depth = random_.between(0, 0.15);
    }
    for (Furrow& furrow : shape_.sides.furrows) furrow.depth = scaled(furrow.depth, random_.between(0.5, 1.2));
  }

  void vary_chamber() {
    PulpChamber& box = shape_.chamber;
    for (double* x : {&box.low.x, &box.high.x, &box.low.y, &box.high.y}) *x *= about(0.2);
    box.low.z += random_.between(-0.4, 0.3);
    box.high.z += random_.between(-0.4, 0.5);
    box.exponent = random_.between(2.0, 3.2);
    box.rounding = std::min({box.rounding * about(0.25), (box.high.z - box.low.z) / 2});
  }

  void vary_horns() {
    for (Horn& horn : shape_.horns) {
      const double reach = random_.between(0.7, 1.25);
      horn.tip.z = horn.base.z + (horn.tip.z - horn.base.z) * reach;
      horn.tip.x += random_.between(-0.2, 0.2);
      horn.tip.y += random_.between(-0.2, 0.2);
      horn.base_radius *= about(0.2);
      horn.tip_radius = random_.between(0.14, 0.28);
    }
    while (!shape_.horns.empty() && random_.chance(0.25))
      shape_.horns.erase(shape_.horns.begin() + random_.below(static_cast<int>(shape_.horns.size())));
  }

  void add_accessory_canals() {
    if (!random_.chance(0.35)) return;
    const int count = random_.whole(1, 2);
    for (int i = 0; i < count; ++i) {
      const Canal& from =
          shape_.canals[static_cast<std::size_t>(random_.below(static_cast<int>(shape_.canals.size())))];
      const double low = shape_.roots[from.root].apex_z;
      const double z = random_.between(low + 2.5, std::min(low + 7, 11.0));
      const double turn = random_.between(-pi, pi), fall = random_.between(35, 70) * pi / 180;
      const Point3 start = canal_centre(shape_, from, z);
      const double radius = random_.between(0.13, 0.2);
      const auto at = [&](double length) {
        return Point3{start.x + length * std::cos(fall) * std::cos(turn),
                      start.y + length * std::cos(fall) * std::sin(turn), start.z - length * std::sin(fall)};
      };
      for (double length = 0.3; length < 5; length += 0.1) {
        const Point3 end = at(length);
        if (ToothSection(shape_, end.z).hard_tissue({far_above, far_above}, {end.x, end.y}).tooth < 0.5) continue;
        shape_.accessory_canals.push_back({"accessory", start, end, radius, radius});
        break;
      }
    }
  }

  static constexpr double far_above = 100;

  RandomNumbers random_;
  ToothShape shape_;
};

double dentine_at(const ToothShape& shape, const Point3& at) {
  const OcclusalHeights heights = occlusal_heights(shape, {at.x, at.y});
  return ToothSection(shape, at.z).hard_tissue(heights, {at.x, at.y}).dentine;
}

bool canals_keep_inside(const ToothShape& shape) {
  constexpr double step = 0.25, apical = 1.0;  // mm; near the apex walls may be thin
  for (const Canal& canal : shape.canals) {
    for (double z = shape.roots[canal.root].apex_z + apical; z < shape.canal_top_z; z += step) {
      const Point3 centre = canal_centre(shape, canal, z);
      const double a = canal.half_mesiodistal(z), b = canal.half_buccolingual(z);
      for (const Point2 side : {Point2{a, 0}, Point2{-a, 0}, Point2{0, b}, Point2{0, -b}})
        if (dentine_at(shape, {centre.x + side.x, centre.y + side.y, z}) > -least_wall) return false;
    }
  }
  return true;
}

bool pulp_keeps_inside(const ToothShape& shape) {
  for (const Horn& horn : shape.horns)
    if (dentine_at(shape, horn.tip) > -horn.tip_radius - least_roof) return false;
  const PulpChamber& box = shape.chamber;
  for (const double z : {box.low.z, (box.low.z + box.high.z) / 2, box.high.z}) {
    for (const double x : {box.low.x, 0.0, box.high.x})
      for (const double y : {box.low.y, 0.0, box.high.y})
        if (std::abs(x) + std::abs(y) > 0 && (x == 0 || y == 0) && dentine_at(shape, {x, y, z}) > -least_roof)
          return false;
  }
  return canals_keep_inside(shape);
}

std::string in_words(const RandomTooth& tooth) {
  std::size_t open = 0;
  for (const Canal& canal : tooth.shape.canals) open += canal.open;
  return std::string(name(tooth.shape.kind)) + ", " + std::to_string(tooth.shape.roots.size()) + " roots, " +
         std::to_string(tooth.shape.canals.size()) + " canals (" + std::to_string(open) + " open), " +
         std::to_string(tooth.shape.horns.size()) + " horns, " + std::to_string(tooth.shape.accessory_canals.size()) +
         " accessory, tilt " + std::to_string(static_cast<int>(std::lround(tooth.pose.tilt * 180 / pi)));
}

}  // namespace

RandomTooth random_tooth(std::uint64_t seed) {
  RandomTooth tooth;
  tooth.seed = seed;
  // A drawing whose walls are too thin is drawn again: a few in a hundred stay so for long.
  for (std::uint64_t attempt = 0;; ++attempt) {
    Drawing drawing(seed * 1000003 + attempt * attempt_stride);
    tooth.shape = drawing.shape();
    tooth.pose = drawing.pose();
    tooth.first_slice = drawing.first_slice();
    drawing.add_furcation_canal(tooth.shape);
    if (pulp_keeps_inside(tooth.shape)) break;
  }
  tooth.in_words = in_words(tooth);
  return tooth;
}

}  // namespace odontoscope::test
