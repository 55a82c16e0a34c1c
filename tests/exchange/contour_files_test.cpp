// Contours of other programs: what is right is read, what is wrong is named, and nothing ends otherwise.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "recon/core/error.h"
#include "recon/core/read_file.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/exchange/contour_file.h"
#include "recon/exchange/read_csl.h"
#include "recon/exchange/read_jser.h"
#include "recon/exchange/read_rtstruct.h"
#include "recon/exchange/read_series.h"
#include "recon/exchange/repair_contours.h"
#include "recon/input/character_set.h"
#include "recon/input/validate.h"
#include "tests/exchange/made_files.h"
#include "tests/exchange/refusals.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope {
namespace {

using testing_support::TemporaryFolder;

std::vector<Point2> points_of(const made::Section& what) {
  return parse_series_section(made::section(what), "s.1").contours.at(0).points;
}
std::string section_cause(const std::string& text) {
  return cause_of([&] { parse_series_section(text, "s.1"); });
}

TEST(Series, SectionsBecomeSlices) {
  TemporaryFolder folder;
  testing_support::put(folder / "s.ser", made::series("microns"));
  for (const int i : {1, 2, 4, 10})
    testing_support::put(folder / ("s." + std::to_string(i)), made::section({.index = i}));
  for (const char* other : {"s.x", "s.1x", "s.x.123", "s.", "t.3", "s.one"})
    testing_support::put(folder / other, "nonsense");
  const std::string file = (folder / "s.ser").string();
  const std::string bytes = read_file(file);
  ASSERT_EQ(contour_file_kind(bytes), ContourFileKind::series);
  const FileContours read = read_contour_file(ContourFileKind::series, bytes, file);
  ASSERT_EQ(read.stack.slices.size(), 4u);
  EXPECT_EQ(read.stack.slices[1].z, 0.5 * 1e-3);
  EXPECT_EQ(read.stack.slices[2].z, 1.5 * 1e-3);  // section 3 is missing
  EXPECT_EQ(read.stack.slices[3].z, 4.5 * 1e-3);
  EXPECT_EQ(read.remarks.size(), 2u);
  EXPECT_EQ(read.stack.slices[0].contours.at(0).structure, "Cell");
  EXPECT_EQ(read.stack.slices[0].contours[0].points[2], (Point2{4e-3, 4e-3}));
  EXPECT_NO_THROW(validate(read.stack));
  EXPECT_EQ(cause_of([&] { read_contour_file(ContourFileKind::series, bytes, file, {"domain1"}); }),
            "unknown-structure");
}

TEST(Series, TransformsAreInverted) {
  const Point2 corner = points_of({})[2];
  EXPECT_EQ(corner, (Point2{4, 4}));
  // Of dimension 0 the coefficients mean nothing.
  EXPECT_EQ(points_of({.xcoef = "7 1 0 0 0 0"})[2], corner);
  EXPECT_EQ(points_of({.dimension = "1", .xcoef = "7 9 9 9 9 9", .ycoef = "-1 9 9 9 9 9"})[2], (Point2{-3, 5}));
  const Point2 affine = points_of({.dimension = "3", .xcoef = "1 2 0 9 9 9", .ycoef = "0 1 4 9 9 9"})[2];
  EXPECT_NEAR(affine.x, 1.5, 1e-12);
  EXPECT_NEAR(affine.y, 0.625, 1e-12);
  const std::string bend_x = "0.1 1.01 0.02 0.003 0.001 -0.002", bend_y = "-0.2 -0.03 0.98 0.002 0.001 0.004";
  for (const Point2& p : points_of({.dimension = "6", .xcoef = bend_x, .ycoef = bend_y})) {
    const double u = 0.1 + 1.01 * p.x + 0.02 * p.y + 0.003 * p.x * p.y + 0.001 * p.x * p.x - 0.002 * p.y * p.y;
    const double v = -0.2 - 0.03 * p.x + 0.98 * p.y + 0.002 * p.x * p.y + 0.001 * p.x * p.x + 0.004 * p.y * p.y;
    EXPECT_NEAR(std::min(std::abs(u), std::abs(u - 4)), 0, 1e-10);
    EXPECT_NEAR(std::min(std::abs(v), std::abs(v - 4)), 0, 1e-10);
  }
}

TEST(Series, WrongFilesAreNamed) {
  const std::string good = made::section({});
  EXPECT_EQ(section_cause(good), "accepted");
  EXPECT_EQ(section_cause(""), "unparsable");
  EXPECT_EQ(section_cause("<Section"), "unparsable");
  EXPECT_EQ(section_cause(made::series()), "wrong-type");
  EXPECT_EQ(section_cause(replaced(good, "thickness=\"0.5\"", "")), "missing-key");
  EXPECT_EQ(section_cause(replaced(good, "thickness=\"0.5\"", "thickness=\"0\"")), "repeated-z");
  EXPECT_EQ(section_cause(replaced(good, "index=\"1\"", "index=\"1.5\"")), "unparsable");
  EXPECT_EQ(section_cause(made::section({.points = "0 0, 4 0, 4"})), "unparsable");
  EXPECT_EQ(section_cause(made::section({.points = "0 0, 4 0, 4 x"})), "unparsable");
  EXPECT_EQ(section_cause(made::section({.points = "0 0, 4 0, 4 nan"})), "not-finite");
  EXPECT_EQ(section_cause(made::section({.dimension = "7"})), "bad-transform");
  EXPECT_EQ(section_cause(made::section({.dimension = "3", .xcoef = "0 0 0 0 0 0"})), "bad-transform");
  EXPECT_EQ(section_cause(made::section({.dimension = "3", .xcoef = "0 1 0"})), "bad-transform");
  EXPECT_EQ(section_cause(made::section({.name = ""})), "bad-name");
  EXPECT_EQ(section_cause(made::section({.name = "a&#7;b"})), "bad-name");
  EXPECT_EQ(parse_series_section(made::section({.closed = "false"}), "s.1").open, 1u);
  EXPECT_EQ(cause_of([] { parse_series_header(made::series("parsecs"), "s.ser"); }), "wrong-unit");
  EXPECT_EQ(cause_of([] { read_series(made::series(), "/nowhere-at-all.ser"); }), "no-sections");
  TemporaryFolder folder;
  testing_support::put(folder / "s.2", made::section({.index = 3}));
  EXPECT_EQ(cause_of([&] { read_series(made::series(), (folder / "s.ser").string()); }), "wrong-section");
}

TEST(Series, NoEntityIsExpandedAndNothingHangs) {
  std::string laughs = "<!DOCTYPE Section [<!ENTITY a \"ha\">";
  for (char c = 'b'; c <= 'z'; ++c)
    laughs +=
        std::string("<!ENTITY ") + c + " \"&" + static_cast<char>(c - 1) + ";&" + static_cast<char>(c - 1) + ";\">";
  EXPECT_NE(section_cause(laughs + "]>" +
                          replaced(made::section({.name = "&z;"}), "<!DOCTYPE Section SYSTEM \"section.dtd\">", "")),
            "nothing");
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_EQ(section_cause(deep), "unparsable");
  truncate(made::section({}), [](const std::string& bytes) { parse_series_section(bytes, "s.1"); });
}

// --- CSL -------------------------------------------------------------------------------------------------------------

std::string csl_cause(const std::string& text) {
  return cause_of([&] { parse_csl(text, "file"); });
}

TEST(Csl, PlanesBecomeSlicesAndHolesStayTheirs) {
  ASSERT_EQ(contour_file_kind(made::csl()), ContourFileKind::csl);
  const FileContours read = parse_csl(made::csl(), "file");
  ASSERT_EQ(read.stack.slices.size(), 2u);
  EXPECT_EQ(read.stack.slices[0].z, 1);
  EXPECT_EQ(read.stack.slices[1].z, 3);
  ASSERT_EQ(read.stack.slices[1].contours.size(), 2u);
  for (const Contour& contour : read.stack.slices[1].contours) EXPECT_EQ(contour.structure, "tooth");
  EXPECT_EQ(read.stack.slices[1].contours[1].points[1], (Point2{2, 4}));
  EXPECT_TRUE(read.remarks.empty());
  const FileContours labelled = parse_csl(replaced(made::csl(), "2 2\n", "2 3\n"), "file");
  EXPECT_EQ(labelled.stack.slices[1].contours[1].structure, "label 1");  // a hole of it
  EXPECT_EQ(reconstruct(read.stack).solids.size(), 1u);
}

TEST(Csl, PlanesMayLieAnyWay) {
  // x to y to z to x: the same square across y.
  const std::string across_y =
      "CSLC\n2 2\n1 3 1 0 1 0 -1\n0 1 0\n0 1 4\n4 1 0\n3 1 0 2 1\n2 3 1 0 -1 0 2\n0 2 0\n0 2 4\n4 2 0\n3 1 0 2 1\n";
  const FileContours turned = parse_csl(across_y, "file");
  EXPECT_EQ(turned.stack.slices[0].z, 1);
  EXPECT_EQ(turned.stack.slices[1].z, 2);                                      // its normal points the other way
  EXPECT_EQ(turned.stack.slices[0].contours.at(0).points[2], (Point2{4, 0}));  // (z, x)
  // Slanted: distances stay.
  const std::string slanted =
      "CSLC\n2 2\n1 3 1 1 1 1 0\n0 0 0\n1 -1 0\n0 1 -1\n3 1 0 1 2\n2 3 1 1 1 1 -3\n1 1 1\n2 0 1\n1 2 0\n3 1 0 1 2\n";
  const FileContours read = parse_csl(slanted, "file");
  EXPECT_NEAR(read.stack.slices[1].z - read.stack.slices[0].z, std::sqrt(3), 1e-12);
  const auto& points = read.stack.slices[0].contours.at(0).points;
  EXPECT_NEAR(std::hypot(points[1].x - points[0].x, points[1].y - points[0].y), std::sqrt(2), 1e-12);
}

TEST(Csl, WrongFilesAreNamed) {
  const std::string good = made::csl();
  EXPECT_EQ(csl_cause("CSLX\n"), "bad-header");
  EXPECT_EQ(csl_cause(good + " 1"), "trailing-bytes");
  EXPECT_EQ(csl_cause(replaced(good, "0 0 2 -6", "0 1 2 -6")), "not-parallel");
  EXPECT_EQ(csl_cause(replaced(good, "0 0 2 -6", "0 0 0 -6")), "unparsable");
  EXPECT_EQ(csl_cause(replaced(good, "0 0 2 -6", "0 0 2 -2")), "repeated-z");
  EXPECT_EQ(csl_cause(replaced(good, "8 8 3", "8 8 4")), "off-plane");
  EXPECT_EQ(csl_cause(replaced(good, "8 8 3", "8 8 nan")), "not-finite");
  EXPECT_EQ(csl_cause(replaced(good, "8 8 3", "8 1e9 3")), "too-large");
  EXPECT_EQ(csl_cause(replaced(good, "4h0 2 4 5 6 7", "4h0 2 4 5 6 8")), "index-out-of-range");
  EXPECT_EQ(csl_cause(replaced(good, "4h0", "4h1")), "index-out-of-range");
  EXPECT_EQ(csl_cause(replaced(good, "4h0", "4h")), "truncated");
  EXPECT_EQ(csl_cause(replaced(good, "4h0", "4hx")), "unparsable");
  EXPECT_EQ(parse_csl(replaced(good, "8 8 3", "8 8 3.1"), "file").remarks.size(), 1u);
}

TEST(Csl, LyingCountsEndSoon) {
  const std::string good = made::csl();
  for (const char* count : {"8000000", "99999999", "100000001", "1e15", "-1", "18446744073709551616"}) {
    EXPECT_NE(csl_cause(replaced(good, "2 8 2", std::string("2 ") + count + " 2")), "accepted") << count;
    EXPECT_NE(csl_cause(replaced(good, "4h0 2", std::string(count) + "h0 2")), "accepted") << count;
    EXPECT_NE(csl_cause(replaced(good, "2 2\n", std::string(count) + " 2\n")), "accepted") << count;
  }
  truncate(good, [](const std::string& bytes) { parse_csl(bytes, "file"); });
}

// --- RTSTRUCT --------------------------------------------------------------------------------------------------------

// --- real data -------------------------------------------------------------------------------------------------------

FileContours real(const std::string& name, const std::vector<std::string>& structures) {
  const std::string file = std::string(ODONTOSCOPE_DATA) + "/" + name, bytes = read_file(file);
  return read_contour_file(contour_file_kind(bytes).value(), bytes, file, structures);
}

bool is_missing(const std::string& name) {
  return std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(std::string(ODONTOSCOPE_DATA) + "/" + name);
}

TEST(CharacterSet, NamesBecomeUtf8) {
  EXPECT_EQ(to_utf8("Z\xe4hne", "ISO_IR 100").utf8, "Z\xc3\xa4hne");
  EXPECT_EQ(to_utf8("Z\xc3\xa4hne", "ISO_IR 192").utf8, "Z\xc3\xa4hne");
  EXPECT_EQ(to_utf8("\xb7\xe3\xdf", "ISO_IR 144").utf8, "\xd0\x97\xd1\x83\xd0\xbf");
  EXPECT_FALSE(to_utf8("Tooth", "").guessed);
  EXPECT_TRUE(to_utf8("Z\xc3\xa4hne", "").guessed);
  EXPECT_EQ(to_utf8("a\x1b[2Jb\n", "ISO_IR 192").utf8.find('\x1b'), std::string::npos);
}

TEST(Csl, AHoleMayComeBeforeItsOwner) {
  const std::string text = "CSLC\n1 2\n0 8 2 0 0 1 0\n0 0 0\n6 0 0\n6 6 0\n0 6 0\n2 2 0\n4 2 0\n4 4 0\n2 4 0\n";
  const FileContours read = parse_csl(text + "4h1 0 4 7 6 5\n4 1 0 1 2 3\n", "file");
  ASSERT_EQ(read.stack.slices.at(0).contours.size(), 2u);
  EXPECT_EQ(enclosed(read.stack.slices[0].contours[0]), 4);
  EXPECT_THROW(parse_csl(text + "4h1 0 4 7 6 5\n4h0 1 0 1 2 3\n", "file"), InputError);
  EXPECT_THROW(parse_csl(text + "4h2 0 4 7 6 5\n4 1 0 1 2 3\n", "file"), InputError);
}

// --- PyReconstruct ---------------------------------------------------------------------------------------------------

/// Two sections, the second after one that is missing; a square of 4 um with a hole, an open trace, and a turn by 90
/// degrees as alignment.
std::string jser(const std::string& alignment = "default") {
  const std::string look = ",[255,0,0],true,false,false,[\"none\",\"none\"],[]]",
                    open = ",[255,0,0],false,false,false,[\"none\",\"none\"],[]]";
  const std::string contours = "{\"cell\":[[[0,4,4,0],[0,0,4,4]" + look + ",[[1,2,2,1],[1,1,2,2]" + look +
                               "],\"line\":[[[0,1],[0,1]" + open + "]}";
  const std::string section =
      "{\"src\":\"a.tif\",\"mag\":0.00254,\"thickness\":0.05,\"tforms\":{\"default\":[1,0,0,0,1,0],\"turned\":[0,-1,10,"
      "1,0,0]},\"contours\":" +
      contours + "}";
  return "{\"sections\": [null," + section + ",null," + section + "], \"series\": {\"alignment\": \"" + alignment +
         "\"}, \"log\": \"\"}";
}

TEST(Jser, SectionsOfPyReconstruct) {
  ASSERT_EQ(contour_file_kind(jser()), ContourFileKind::jser);
  const FileContours read = parse_jser(jser(), "file");
  EXPECT_NO_THROW(validate(read.stack));
  ASSERT_EQ(read.stack.slices.size(), 2u);
  EXPECT_EQ(read.stack.slices[0].z, 0);
  EXPECT_DOUBLE_EQ(read.stack.slices[1].z, 0.0001);  // two thicknesses of 0.05 um
  ASSERT_EQ(read.stack.slices[0].contours.size(), 2u);
  EXPECT_EQ(read.stack.slices[0].contours[0].structure, "cell");
  EXPECT_DOUBLE_EQ(read.stack.slices[0].contours[0].points[1].x, 0.004);
  EXPECT_EQ(read.remarks.size(), 2u);  // the missing section, the open traces
  const FileContours turned = parse_jser(jser("turned"), "file");
  EXPECT_DOUBLE_EQ(turned.stack.slices[0].contours[0].points[1].x, 0.010);
  EXPECT_DOUBLE_EQ(turned.stack.slices[0].contours[0].points[1].y, 0.004);
  EXPECT_NO_THROW(parse_jser(jser("no-alignment"), "file"));
}

TEST(Jser, WrongFilesAreNamed) {
  const auto cause = [](const std::string& text) { return cause_of([&] { parse_jser(text, "file"); }); };
  EXPECT_EQ(cause(jser("missing")), "missing-key");
  EXPECT_EQ(cause(jser().substr(0, 300)), "unparsable");
  EXPECT_EQ(cause(replaced(jser(), "\"thickness\":0.05", "\"thickness\":0")), "repeated-z");
  EXPECT_EQ(cause(replaced(jser(), "\"thickness\":0.05", "\"thickness\":1e30")), "too-large");
  EXPECT_EQ(cause(replaced(jser(), "[0,4,4,0]", "[0,4,4]")), "wrong-type");
  EXPECT_EQ(cause(replaced(jser(), "[0,4,4,0]", "[0,4,\"4\",0]")), "wrong-type");
  EXPECT_EQ(cause(replaced(jser(), "[0,4,4,0]", "[0,4,1e9999,0]")), "unparsable");
  EXPECT_EQ(cause(replaced(jser(), "[1,0,0,0,1,0]", "[1,0,0,0,1]")), "wrong-type");
  EXPECT_EQ(cause(replaced(jser(), "[1,0,0,0,1,0]", "[1,1,0,1,1,0]")), "bad-transform");
  EXPECT_EQ(cause("{\"sections\": [null], \"series\": {}}"), "no-sections");
  EXPECT_EQ(cause("{\"sections\": {}, \"series\": {}}"), "wrong-type");
  EXPECT_EQ(cause("{\"sections\": []}"), "missing-key");
}

TEST(RealContours, SeriesOfReconstruct) {
  const std::string name = "reconstruct_series/calibrated_organelle.ser";
  if (is_missing(name)) GTEST_SKIP() << "the series is not there; set the CMake variable ODONTOSCOPE_DATA";
  const FileContours read = real(name, {"Cell", "org1", "org2"});
  ASSERT_EQ(read.stack.slices.size(), 25u);
  const Reconstruction model = reconstruct(read.stack);
  ASSERT_EQ(model.solids.size(), 3u);
  for (const Solid& solid : model.solids) {
    ASSERT_EQ(solid.report.shells.size(), 1u) << solid.structure;
    EXPECT_EQ(solid.report.shells[0].genus, 0);
    EXPECT_TRUE(solid.report.closed_oriented_manifold());
  }
  EXPECT_NEAR(model.solids[0].report.shells[0].volume, 3.61e-10, 1e-12);  // 0.36 cubic micrometres
}

TEST(RealContours, StructureSet) {
  const std::string name = "rtstruct/rtss.dcm";
  if (is_missing(name)) GTEST_SKIP() << "the structure set is not there; set the CMake variable ODONTOSCOPE_DATA";
  for (const std::string structure : {"BODY", "Lt Lung", "Heart"}) {
    const FileContours read = real(name, {structure});
    for (std::size_t s = 1; s < read.stack.slices.size(); ++s)
      EXPECT_NEAR(read.stack.slices[s].z - read.stack.slices[s - 1].z, 3, 1e-9);
    const Reconstruction model = reconstruct(read.stack);
    EXPECT_TRUE(model.certified);
    EXPECT_EQ(model.slices_checked, read.stack.slices.size());
    EXPECT_EQ(read.stack.slices.size(), structure == "BODY" ? 98u : structure == "Heart" ? 33u : 80u);
  }
  EXPECT_EQ(cause_of([&] { real(name, {"Rt Lung"}); }), "unknown-structure");
}

TEST(RealContours, TruncatedAtEveryKilobyte) {
  if (!is_missing("reconstruct_series/calibrated_organelle.12")) {
    const std::string section =
        read_file(std::string(ODONTOSCOPE_DATA) + "/reconstruct_series/calibrated_organelle.12");
    truncate(section, [](const std::string& bytes) { parse_series_section(bytes, "s.12"); });
  }
  if (is_missing("rtstruct/rtss.dcm")) GTEST_SKIP() << "the structure set is not there";
  const std::string set = read_file(std::string(ODONTOSCOPE_DATA) + "/rtstruct/rtss.dcm");
  for (std::size_t n = 1024; n < set.size(); n += 1024) EXPECT_EQ(set_cause(set.substr(0, n)), "truncated") << n;
}

}  // namespace
}  // namespace odontoscope
