#include "recon/input/validate.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <type_traits>
#include <utility>

#include "recon/core/limits.h"
#include "recon/input/stack_json.h"
#include "tests/input/shapes.h"

namespace odontoscope {
namespace {

using shapes::between_squares, shapes::circle, shapes::of, shapes::reversed, shapes::square, shapes::tooth;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<InputError> error_of(const ContourStack& stack) {
  try {
    validate(stack);
  } catch (const InputError& error) {
    return error;
  }
  return {};
}

std::string cause_of(const ContourStack& stack) {
  const auto error = error_of(stack);
  return error ? error->cause() : "valid";
}

// --- one named case a rule ---------------------------------------------------------------------------------------

struct Case {
  const char* name;
  std::string cause;
  ContourStack stack;
};

std::vector<Case> cases() {
  const auto one = [](shapes::Points points) { return between_squares({tooth(std::move(points))}); };
  const auto two = [](shapes::Points a, shapes::Points b) { return between_squares({tooth(a), tooth(b)}); };
  return {
      {"square", "valid", one(square(0, 0, 1))},
      {"empty_slice_between", "valid", between_squares({})},
      {"clockwise", "valid", one(reversed(square(0, 0, 1)))},
      {"points_along_a_straight_edge", "valid", one({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}})},
      {"nested_four_deep", "valid",
       between_squares({tooth(circle(0, 0, 4, 20)), tooth(circle(0, 0, 3, 20)), tooth(circle(0, 0, 2, 20)),
                        tooth(circle(0, 0, 1, 20))})},
      {"coincident_contours_of_two_structures", "valid",
       between_squares({of("enamel", square(0, 0, 1)), of("dentine", square(0, 0, 1))})},
      {"crossing_contours_of_two_structures", "valid",
       between_squares({of("enamel", square(0, 0, 2)), of("dentine", square(1, 1, 2))})},
      {"hairline_gap", "valid", two(square(0, 0, 1), square(std::nextafter(1, 2), 0, 1))},
      {"no_slices", "empty-stack", {{}, "test.json"}},
      {"no_contours", "empty-stack", {{{0, {}}, {1, {}}}, "test.json"}},
      {"single_slice", "single-slice", {{{0, {tooth(square(0, 0, 1))}}}, "test.json"}},
      {"repeated_z",
       "repeated-z",
       {{{2, {tooth(square(0, 0, 1))}}, {1, {}}, {2, {tooth(square(0, 0, 1))}}}, "test.json"}},
      {"signed_zero_z", "repeated-z", {{{0.0, {tooth(square(0, 0, 1))}}, {-0.0, {}}}, "test.json"}},
      {"nan_z", "not-finite", {{{nan, {tooth(square(0, 0, 1))}}, {1, {}}}, "test.json"}},
      {"huge_z", "too-large", {{{2e6, {tooth(square(0, 0, 1))}}, {1, {}}}, "test.json"}},
      {"nan_x", "not-finite", one({{0, 0}, {nan, 0}, {1, 1}})},
      {"infinite_y", "not-finite", one({{0, 0}, {1, -infinity}, {1, 1}})},
      {"huge_x", "too-large", one({{0, 0}, {1.5e6, 0}, {1, 1}})},
      {"no_points", "too-few-points", one({})},
      {"two_points", "too-few-points", one({{0, 0}, {1, 0}})},
      {"closed_twice", "repeated-point", one({{0, 0}, {1, 0}, {1, 1}, {0, 0}})},
      {"stuttering", "repeated-point", one({{0, 0}, {1, 0}, {1, 0}, {1, 1}})},
      {"visits_a_place_twice", "repeated-point", one({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}})},
      {"on_a_line", "zero-area", one({{0, 0}, {1, 1}, {3, 3}, {2, 2}})},
      {"figure_of_eight", "self-crossing", one({{0, 0}, {2, 2}, {2, 0}, {0, 2}})},
      {"spike", "self-crossing", one({{0, 0}, {2, 0}, {2, 2}, {2, 5}, {2, 1}, {0, 2}})},
      {"spike_of_no_width", "self-crossing", one({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 5}, {0, 4}})},
      {"passes_through_own_point", "self-crossing", one({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})},
      {"overlaps_own_edge", "self-crossing", one({{0, 0}, {9, 0}, {9, 3}, {6, 3}, {6, 0}, {3, 0}, {3, 3}, {0, 3}})},
      {"crossing", "contours-cross", two(square(0, 0, 2), square(1, 1, 2))},
      {"bar_across", "contours-cross", two(square(0, 0, 3), {{-1, 1}, {4, 1}, {4, 2}, {-1, 2}})},
      {"shared_point", "contours-touch", two(square(0, 0, 1), square(1, 1, 1))},
      {"point_on_edge", "contours-touch", two(square(0, 0, 2), {{2, 1}, {3, 0}, {3, 2}})},
      {"hole_touches_from_inside", "contours-touch", two(square(0, 0, 4), {{0, 2}, {1, 1}, {1, 3}})},
      {"overlapping_edges", "contours-touch", two(square(0, 0, 4), {{4, 1}, {6, 1}, {6, 3}, {4, 3}})},
      {"coincident", "contours-touch", two(square(0, 0, 1), square(0, 0, 1))},
      {"nameless", "bad-name", between_squares({of("", square(0, 0, 1))})},
      {"name_with_newline", "bad-name", between_squares({of("a\nb", square(0, 0, 1))})},
      {"name_not_utf8", "bad-name", between_squares({of("pocket\xe9", square(0, 0, 1))})},
      {"name_longer_than_its_utf8_needs", "bad-name", between_squares({of("\xe0\x80\xaf", square(0, 0, 1))})},
      {"name_with_utf8_surrogate", "bad-name", between_squares({of("\xed\xa0\x80", square(0, 0, 1))})},
      {"name_with_cut_utf8", "bad-name", between_squares({of("a\xe2\x82", square(0, 0, 1))})},
      {"name_overlong_utf8", "bad-name", between_squares({of("\xc0\xaf", square(0, 0, 1))})},
      {"long_name", "bad-name", between_squares({of(std::string(limits::name_length + 1, 'x'), square(0, 0, 1))})},
      {"name_with_accents", "valid", between_squares({of("Schmelz-Dentin-Größe ✓", square(0, 0, 1))})},
  };
}

TEST(Validate, GivesEachRuleItsCause) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const auto error = error_of(c.stack);
    EXPECT_EQ(error ? error->cause() : "valid", c.cause);
    if (error) {
      EXPECT_EQ(error->exit_code(), ExitCode::bad_input);
      EXPECT_EQ(error->place().file, "test.json");
      EXPECT_NE(std::string(error->what()).find("[" + c.cause + "]"), std::string::npos) << error->what();
    }
  }
}

TEST(Validate, IsTheOnlyWayToAValidStackWhichNeverChanges) {
  static_assert(!std::is_constructible_v<ValidStack, ContourStack> && !std::is_default_constructible_v<ValidStack>);
  static_assert(std::is_same_v<decltype(*std::declval<ValidStack&>()), const ContourStack&>);
  const ContourStack given = between_squares({});
  const ValidStack valid = validate(given), same = valid;
  EXPECT_EQ(to_json(*valid), to_json(given));
  EXPECT_EQ(&*valid, &*same);
}

TEST(Validate, GuardsTheCounts) {
  ContourStack slices = between_squares({});
  for (std::size_t i = 0; i <= limits::slices; ++i) slices.slices.push_back({100.0 + double(i), {}});
  EXPECT_EQ(cause_of(slices), "too-many-slices");
  EXPECT_EQ(cause_of(between_squares(std::vector<Contour>(limits::contours_per_slice + 1, tooth(square(0, 0, 1))))),
            "too-many-contours");
  std::vector<Contour> structures;
  for (std::size_t i = 0; i < limits::structures; ++i) {
    structures.push_back(of(std::to_string(i), square(double(i), 0, 0.5)));
  }
  EXPECT_EQ(cause_of(between_squares(structures)), "too-many-structures");  // with "tooth" one too many
  structures.pop_back();
  EXPECT_EQ(cause_of(between_squares(structures)), "valid");
}

// --- places ------------------------------------------------------------------------------------------------------

TEST(Validate, NamesSliceContourPointAndPlace) {
  const auto error = error_of(between_squares({tooth(square(10, 0, 1)), tooth({{0, 0}, {2, 2}, {2, 0}, {0, 2}})}));
  ASSERT_TRUE(error);
  const Place& place = error->place();
  EXPECT_EQ(place.slice, 1u);
  EXPECT_EQ(place.z, 1.0);
  EXPECT_EQ(place.contour, 1u);
  EXPECT_EQ(place.point, 0u);
  EXPECT_EQ(place.at, (Point2{1, 1}));
}

TEST(Validate, ReportsTheFirstOfTwoRepeatedHeights) {
  for (const auto& heights : {std::vector{2.0, 1.0, 3.0, 2.0, 1.0}, std::vector{1.0, 2.0, 3.0, 1.0, 2.0}}) {
    ContourStack stack;
    for (const double z : heights) stack.slices.push_back({z, {tooth(square(0, 0, 1))}});
    const auto error = error_of(stack);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->cause(), "repeated-z");
    EXPECT_EQ(error->place().slice, 3u);
  }
}

/// Slice 5 is found broken while another thread is still busy with a large broken one further up.
TEST(Validate, ReportsTheFirstBrokenSliceOnAnyNumberOfThreads) {
  ContourStack stack;
  for (int s = 0; s < 100; ++s) {
    shapes::Points points = circle(0, 0, 1, s < 5 ? 2'000 : s == 5 ? 10 : 20'000);
    if (s >= 5) std::swap(points[points.size() / 2], points[points.size() / 2 + 1]);
    stack.slices.push_back({double(s), {tooth(points)}});
  }
  std::string first;
  for (const std::size_t threads : {1, 2, 7}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (int again = 0; again < 10; ++again) {
      const auto error = error_of(stack);
      ASSERT_TRUE(error);
      EXPECT_EQ(error->place().slice, 5u);
      if (first.empty()) first = error->what();
      EXPECT_EQ(first, error->what());
    }
  }
}

TEST(Validate, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  Progress progress;
  progress.stop = source.get_token();
  EXPECT_THROW(validate(between_squares({tooth(square(0, 0, 1))}), progress), Cancelled);
}

// --- what must not change the verdict ----------------------------------------------------------------------------

using Change = std::function<void(ContourStack&)>;

void each_point(ContourStack& stack, const std::function<Point2(Point2)>& map) {
  for (Slice& slice : stack.slices)
    for (Contour& contour : slice.contours)
      for (Point2& p : contour.points) p = map(p);
}

void each_contour(ContourStack& stack, const std::function<void(shapes::Points&)>& change) {
  for (Slice& slice : stack.slices)
    for (Contour& contour : slice.contours)
      if (!contour.points.empty()) change(contour.points);
}

std::vector<std::pair<const char*, Change>> changes() {
  return {
      {"rotated", [](ContourStack& s) { each_point(s, [](Point2 p) {
                                          return Point2{-p.y, p.x};
                                        }); }},
      {"rotated twice", [](ContourStack& s) { each_point(s, [](Point2 p) {
                                                return Point2{-p.x, -p.y};
                                              }); }},
      {"mirrored", [](ContourStack& s) { each_point(s, [](Point2 p) {
                                           return Point2{-p.x, p.y};
                                         }); }},
      {"transposed", [](ContourStack& s) { each_point(s, [](Point2 p) {
                                             return Point2{p.y, p.x};
                                           }); }},
      {"scaled", [](ContourStack& s) { each_point(s, [](Point2 p) {
                                         return Point2{p.x / 4, p.y / 4};
                                       }); }},
      {"contours reversed",
       [](ContourStack& s) { each_contour(s, [](auto& p) { std::reverse(p.begin(), p.end()); }); }},
      {"started elsewhere",
       [](ContourStack& s) { each_contour(s, [](auto& p) { std::rotate(p.begin(), p.begin() + 1, p.end()); }); }},
      {"contours permuted",
       [](ContourStack& s) {
         for (Slice& slice : s.slices) std::reverse(slice.contours.begin(), slice.contours.end());
       }},
      {"slices permuted", [](ContourStack& s) { std::reverse(s.slices.begin(), s.slices.end()); }},
  };
}

TEST(Validate, VerdictDoesNotDependOnHowItIsWritten) {
  for (const Case& c : cases()) {
    for (const auto& [name, change] : changes()) {
      if (std::string(name) == "scaled" && c.cause == "too-large") continue;
      SCOPED_TRACE(std::string(c.name) + ", " + name);
      ContourStack stack = c.stack;
      change(stack);
      EXPECT_EQ(cause_of(stack), c.cause);
    }
  }
}

/// Random slices may break several rules at once: then only whether they are valid must stay.
TEST(Validate, RandomSlicesKeepTheirVerdict) {
  std::mt19937 random(7);
  int valid = 0, bad = 0;
  for (int round = 0; round < 2'000; ++round) {
    std::vector<Contour> contours;
    for (int c = 0; c < 3; ++c) {
      shapes::Points points;
      for (auto i = 3 + random() % 3; i > 0; --i) points.push_back({double(random() % 24), double(random() % 24)});
      contours.push_back(of(random() % 3 ? "a" : "b", points));
    }
    const ContourStack stack = between_squares(contours);
    const bool verdict = cause_of(stack) == "valid";
    (verdict ? valid : bad)++;
    for (const auto& [name, change] : changes()) {
      ContourStack changed = stack;
      change(changed);
      ASSERT_EQ(cause_of(changed) == "valid", verdict) << "round " << round << ", " << name;
    }
  }
  EXPECT_GT(valid, 50);
  EXPECT_GT(bad, 50);
}

// --- cost --------------------------------------------------------------------------------------------------------

/// The best of three: other work on the machine only ever makes it slower.
/// In processor time, which other programs on the machine do not lengthen.
double seconds_to_validate(const ContourStack& stack) {
  double best = infinity;
  for (int run = 0; run < 3; ++run) {
    const std::clock_t start = std::clock();
    validate(stack);
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

/// Teeth of a comb: all long edges are above each other, the worst case of simpler methods.
shapes::Points comb(std::size_t teeth) {
  shapes::Points points{{-1, 0}};
  for (std::size_t i = 0; i < teeth; ++i) {
    points.push_back({1000, double(i)});
    points.push_back({i % 2 ? 0.5 : 0, double(i) + 0.5});
  }
  points.push_back({-1, double(teeth)});
  return points;
}

TEST(Validate, IsNotQuadratic) {
  const double small = seconds_to_validate(between_squares({tooth(comb(5'000))}));
  const double large = seconds_to_validate(between_squares({tooth(comb(100'000))}));  // 200,000 points
  RecordProperty("seconds_for_200000_points", std::to_string(large));
  EXPECT_LT(large, 20 * small * 6 + 0.05);  // quadratic would be 400 times
}

TEST(Validate, ManySmallContoursAreCheap) {
  const auto islands = [](int count) {
    std::vector<Contour> all;
    for (int i = 0; i < count; ++i) all.push_back(tooth(square(3.0 * (i % 100), 3.0 * (i / 100), 2)));
    return between_squares(all);
  };
  EXPECT_LT(seconds_to_validate(islands(9'000)),
            18 * seconds_to_validate(islands(500)) * 6 + 0.05);  // quadratic would be 324 times
}

// --- ordered -----------------------------------------------------------------------------------------------------

double twice_area(const shapes::Points& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2& q = p[(i + 1) % p.size()];
    sum += p[i].x * q.y - p[i].y * q.x;
  }
  return sum;
}

TEST(Ordered, SortsSlicesAndTurnsContours) {
  const std::vector<Contour> rings = {tooth(circle(0, 0, 1, 16)), tooth(reversed(circle(0, 0, 3, 16))),
                                      of("pulp", reversed(circle(0, 0, 2, 16))), tooth(circle(0, 0, 2, 16))};
  const ContourStack stack{{{5, rings}, {-1, {tooth(reversed(square(0, 0, 1)))}}, {3, {}}}, "test.json"};
  const OrderedStack result = ordered(stack);
  EXPECT_EQ(result.original_slice, (std::vector<std::size_t>{1, 2, 0}));
  ASSERT_EQ(result.stack.slices.size(), 3u);
  EXPECT_EQ(result.stack.source, "test.json");
  EXPECT_EQ(result.stack.slices[0].z, -1);
  EXPECT_EQ(result.stack.slices[2].z, 5);
  const auto& contours = result.stack.slices[2].contours;
  EXPECT_GT(twice_area(contours[0].points), 0);  // an island, two deep
  EXPECT_GT(twice_area(contours[1].points), 0);
  EXPECT_GT(twice_area(contours[2].points), 0);  // another structure: nesting in the tooth does not count
  EXPECT_LT(twice_area(contours[3].points), 0);
  for (std::size_t c = 0; c < rings.size(); ++c) EXPECT_EQ(contours[c].points.front(), rings[c].points.front());
  EXPECT_GT(twice_area(result.stack.slices[0].contours[0].points), 0);
  validate(result.stack);
}

TEST(Ordered, RefusesWhatWasNotValidated) {
  EXPECT_THROW(ordered(between_squares({tooth({{0, 0}, {2, 2}, {2, 0}, {0, 2}})})), InternalError);
}

// --- together ----------------------------------------------------------------------------------------------------

TEST(Together, JoinsTheNamedStructures) {
  const ContourStack stack =
      between_squares({of("pulp", circle(0, 0, 1, 8)), of("enamel", circle(0, 0, 3, 8)), tooth(circle(0, 0, 2, 8))});
  const ContourStack joined = together(stack, {"tooth", "pulp", "tooth"});
  EXPECT_EQ(structures_of(joined), (std::vector<std::string>{"tooth+pulp", "enamel"}));
  EXPECT_EQ(structures_of(stack), (std::vector<std::string>{"tooth", "pulp", "enamel"}));
  EXPECT_EQ(cause_of(joined), "valid");
}

TEST(Together, MustBeValidatedAgain) {
  const ContourStack stack = between_squares({of("a", square(0, 0, 2)), of("b", square(1, 1, 2))});
  EXPECT_EQ(cause_of(stack), "valid");
  EXPECT_EQ(cause_of(together(stack, {"a", "b"})), "contours-cross");
}

TEST(Together, RefusesUnknownAndTakenNames) {
  const ContourStack stack = between_squares({of("a", square(0, 0, 1)), of("tooth+a", square(5, 5, 1))});
  const auto cause = [&](std::vector<std::string> names) {
    try {
      together(stack, names);
    } catch (const InputError& error) {
      return error.cause();
    }
    return std::string("none");
  };
  EXPECT_EQ(cause({"a", "Tooth"}), "unknown-structure");
  EXPECT_EQ(cause({"tooth", "a"}), "bad-name");
  EXPECT_EQ(cause({"a", "tooth"}), "none");
}

}  // namespace
}  // namespace odontoscope
