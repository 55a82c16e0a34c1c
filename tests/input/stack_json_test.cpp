#include "recon/input/stack_json.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "recon/core/limits.h"
#include "recon/input/json_source.h"
#include "recon/input/links_json.h"
#include "recon/input/validate.h"
#include "tests/input/shapes.h"

// g++ says so by a macro of its own.
#if defined(__has_feature)
#define ODONTOSCOPE_CLANG_SANITIZES __has_feature(address_sanitizer)
#else
#define ODONTOSCOPE_CLANG_SANITIZES 0
#endif

namespace odontoscope {
namespace {

using shapes::between_squares, shapes::of, shapes::square, shapes::tooth;

InputError error_of(const std::string& text) {
  try {
    parse_stack(text, "test.json");
  } catch (const InputError& error) {
    return error;
  }
  throw std::logic_error("was accepted: " + text);
}

std::string document(const std::string& slices) {
  return R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[)" + slices + "]}";
}

/// A file that vanishes with the test.
struct TemporaryFile {
  explicit TemporaryFile(const std::string& bytes) {
    static int number = 0;
    path = std::filesystem::temp_directory_path() /
           ("odontoscope_input_" + std::to_string(::getpid()) + "_" + std::to_string(number++) + ".json");
    std::ofstream(path, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

// --- messages ----------------------------------------------------------------------------------------------------

TEST(StackJson, NamesLineSliceContourAndPoint) {
  const InputError error =
      error_of(document("\n{\"z\":0,\"contours\":[]},\n{\"z\":2.5,\"contours\":[\n"
                        "{\"points\":[]},\n{\"points\":[[0,0],[1,0],[1,\"x\"]]}]}"));
  EXPECT_EQ(error.cause(), "wrong-type");
  EXPECT_EQ(error.place().line, 5u);
  EXPECT_EQ(error.place().slice, 1u);
  EXPECT_EQ(error.place().z, 2.5);
  EXPECT_EQ(error.place().contour, 1u);
  EXPECT_EQ(error.place().point, 2u);
}

TEST(StackJson, NamesTheNearestKey) {
  const std::string what = error_of(document(R"({"z":0,"countours":[]})")).what();
  EXPECT_NE(what.find("Did you mean \"contours\"?"), std::string::npos) << what;
}

TEST(StackJson, NamesLineAndColumnOfWhatIsNoJson) {
  const InputError error = error_of("{\"format\":\n  ?}");
  EXPECT_EQ(error.cause(), "unparsable");
  EXPECT_EQ(error.place().line, 2u);
  EXPECT_NE(std::string(error.what()).find("column 4"), std::string::npos) << error.what();
}

TEST(StackJson, TellsATruncatedFileFromAGarbledOne) {
  const std::string text = to_json(between_squares({tooth(square(0, 0, 1))}));
  EXPECT_NE(std::string(error_of(text.substr(0, text.size() / 2)).what()).find("cut short"), std::string::npos);
  EXPECT_EQ(std::string(error_of("{]" + text).what()).find("cut short"), std::string::npos);
}

// --- limits ------------------------------------------------------------------------------------------------------

TEST(StackJson, StopsAtTheLimitsWhileReading) {
  std::string slices;
  for (std::size_t i = 0; i <= limits::slices; ++i) {
    slices += (i ? ",{\"z\":" : "{\"z\":") + std::to_string(i) + ",\"contours\":[]}";
  }
  EXPECT_EQ(error_of(document(slices)).cause(), "too-many-slices");
  std::string contours;
  for (std::size_t i = 0; i <= limits::contours_per_slice; ++i) contours += i ? ",{\"points\":[]}" : "{\"points\":[]}";
  EXPECT_EQ(error_of(document("{\"z\":0,\"contours\":[" + contours + "]}")).cause(), "too-many-contours");
}

TEST(StackJson, BoundsWhatTheParserHolds) {
  const auto cause = [](const std::string& text) {
    const TemporaryFile file(text);
    try {
      read_stack(file.path.string());
    } catch (const InputError& error) {
      return error.cause();
    }
    return std::string("none");
  };
  const std::string much(2 * limits::json_token, ' '), digits(2 * limits::json_token, '1');
  EXPECT_EQ(cause("{\"x-" + much), "too-large");
  EXPECT_EQ(cause("{\"x-note\":\"" + much), "too-large");
  EXPECT_EQ(cause("{\"x-note\":" + digits), "too-large");
  EXPECT_EQ(cause("{" + much + much), "too-large");
  std::string brackets = "{\"x-note\":[[]";
  for (std::size_t i = 0; i < limits::json_token; ++i) brackets += ",[]";
  EXPECT_EQ(cause(brackets), "too-large");
  EXPECT_EQ(cause("{\"x-note\":" + std::string(200'000, '[')), "too-deep");
  EXPECT_EQ(cause(std::string(200'000, '[')), "wrong-format");
}

TEST(StackJson, SkipsLongNotes) {
  std::string note = "{\"x-note\":[0";
  for (std::size_t i = 0; i < limits::json_token; ++i) note += ",0";
  const std::string text = to_json(between_squares({tooth(square(0, 0, 1))}));
  const TemporaryFile file(note + "]," + text.substr(1));
  EXPECT_EQ(to_json(read_stack(file.path.string())), text);
}

// --- files -------------------------------------------------------------------------------------------------------

TEST(StackJson, FileErrorsAreNotInputErrors) {
  EXPECT_THROW(read_stack("/nonexistent/stack.json"), FileError);
  EXPECT_THROW(read_stack(std::filesystem::temp_directory_path().string()), FileError);
  EXPECT_THROW(write_stack(between_squares({}), "/nonexistent/stack.json"), FileError);
}

/// The pieces that a file is read in must not show: every place of a piece's end within the text.
TEST(StackJson, ReadsAcrossPieces) {
  ContourStack stack = between_squares({tooth(shapes::circle(0, 0, 1, 5000))});
  for (Slice& slice : stack.slices) slice.contours.push_back(of("dentine \"a\\b\" ß", square(5, 5, 1)));
  const std::string text = to_json(stack);
  ASSERT_GT(text.size(), 3 * limits::read_piece);
  for (std::size_t shift = 0; shift < 40; ++shift) {
    const TemporaryFile file(std::string(shift, '\n') + text);
    ASSERT_EQ(to_json(read_stack(file.path.string())), text);
    const TemporaryFile broken(std::string(shift, '\n') + text.substr(0, text.size() - 4) + "\n?");
    try {
      read_stack(broken.path.string());
      FAIL();
    } catch (const InputError& error) {
      const std::string before = std::string(shift, '\n') + text.substr(0, text.size() - 4);
      ASSERT_EQ(error.place().line, static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 2);
      ASSERT_NE(std::string(error.what()).find("column 2 "), std::string::npos) << error.what();
    }
  }
}

TEST(StackJson, WritesWhatItReads) {
  const ContourStack stack = between_squares({tooth(shapes::circle(0.1, 1.0 / 3, 1e-9, 50))});
  const TemporaryFile file("old");
  write_stack(stack, file.path.string());
  EXPECT_EQ(to_json(read_stack(file.path.string())), to_json(stack));
}

TEST(StackJson, AnyDoubleSurvives) {
  std::mt19937_64 random(11);
  shapes::Points points;
  while (points.size() < 20'000) {
    Point2 p;
    const std::uint64_t bits[2] = {random(), random()};
    std::memcpy(&p.x, &bits[0], sizeof p.x);
    std::memcpy(&p.y, &bits[1], sizeof p.y);
    if (std::abs(p.x) <= limits::largest_coordinate && std::abs(p.y) <= limits::largest_coordinate) points.push_back(p);
  }
  const ContourStack again = parse_stack(to_json(between_squares({tooth(points)})), "again");
  EXPECT_EQ(again.slices[1].contours[0].points, points);
}

TEST(StackJson, AContourALine) {
  const std::string text = to_json(between_squares({of("pulp", square(0, 0, 1)), tooth({{0.5, -0.0}})}));
  EXPECT_NE(text.find("\n {\"structure\":\"pulp\",\"points\":[[0,0],[1,0],[1,1],[0,1]]},\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\n {\"structure\":\"tooth\",\"points\":[[0.5,0]]}]}"), std::string::npos) << text;
}

/// A large stack takes little more memory than itself: the file never lies in memory.
TEST(StackJson, ALargeFileNeedsLittleMemory) {
#if defined(__SANITIZE_ADDRESS__) || ODONTOSCOPE_CLANG_SANITIZES
  GTEST_SKIP() << "a sanitizer has its own memory";
#endif
  const auto peak = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024;
  };
  const TemporaryFile file("");
  {
    std::ofstream out(file.path);
    out << R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[)";
    const std::string one = to_json(between_squares({tooth(shapes::circle(0, 0, 10, 1'100))}));
    const std::size_t begin = one.find("\n {", one.find("\"z\":1,")), end = one.find("]}", begin);
    for (int s = 0; s < 1'000; ++s)
      out << (s ? "," : "") << "{\"z\":" << s << ",\"contours\":[" << one.substr(begin, end - begin) << "]}]}";
    out << "]}";
  }
  const double before = peak();
  const ContourStack stack = read_stack(file.path.string());
  ASSERT_EQ(stack.slices.size(), 1'000u);
  const double points = 1'000.0 * 1'100 * sizeof(Point2),
               bytes = static_cast<double>(std::filesystem::file_size(file.path));
  EXPECT_GT(bytes, 2 * points);
  EXPECT_LT(peak() - before, 1.5 * points + (1 << 20));
}

}  // namespace
}  // namespace odontoscope
