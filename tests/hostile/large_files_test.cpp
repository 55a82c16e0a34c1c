// Files a thousand times larger than they should be, in every way that a format has of being large: read, or refused
// with a cause, in bounded memory and time.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "recon/core/limits.h"
#include "tests/exchange/made_files.h"
#include "tests/hostile/bounded.h"
#include "tests/hostile/readers.h"
#include "tests/volume/dicomdir.h"

namespace odontoscope::hostile {
namespace {

std::string times(std::size_t count, const std::string& piece, const std::string& between = "") {
  std::string text;
  text.reserve(count * (piece.size() + between.size()));
  for (std::size_t n = 0; n < count; ++n) {
    if (n > 0) text += between;
    text += piece;
  }
  return text;
}

/// A piece for each number, with the number in place of '#'.
std::string numbered(std::size_t count, const std::string& piece, const std::string& between = ",") {
  const std::size_t at = piece.find('#');
  std::string text;
  for (std::size_t n = 0; n < count; ++n) {
    if (n > 0) text += between;
    text += piece.substr(0, at) + std::to_string(n) + piece.substr(at + 1);
  }
  return text;
}

struct Large {
  std::string reader, what;
  std::string (*make)();
  std::string outcome;
  Bounds bounds = {};
  friend void PrintTo(const Large& large, std::ostream* out) { *out << large.reader << ": " << large.what; }
};

// --- our own JSON ----------------------------------------------------------------------------------------------------

std::string stack_of(const std::string& slices, const std::string& more = "") {
  return "{\"format\":\"odontoscope.contours\",\"version\":1,\"unit\":\"mm\"," + more + "\"slices\":[" + slices + "]}";
}
std::string slice_of(const std::string& contours) { return "{\"z\":#,\"contours\":[" + contours + "]}"; }
const std::string square = "{\"points\":[[0,0],[1,0],[1,1]]}";

std::vector<Large> json_files() {
  return {
      {"stack", "two million empty contours",
       [] { return stack_of(numbered(200, slice_of(times(9'999, "{\"points\":[]}", ",")))); }, "accepted"},
      {"stack", "ten million ends of line",
       [] { return times(10'000'000, "\n") + stack_of(numbered(20, slice_of(times(2'000, square, ",")))); },
       "accepted"},
      {"stack", "too many contours",
       [] { return stack_of(numbered(2, slice_of(times(limits::contours_per_slice + 1, square, ",")))); },
       "too-many-contours"},
      {"stack", "too many slices", [] { return stack_of(numbered(limits::slices + 1, slice_of(""))); },
       "too-many-slices"},
      {"stack", "ten million brackets", [] { return times(10'000'000, "["); }, "wrong-format"},
      {"stack", "a note of a million brackets", [] { return stack_of("", "\"x-deep\":" + times(1'000'000, "[")); },
       "too-deep"},
      {"stack", "a note of thirty million numbers",
       [] { return stack_of("", "\"x-long\":[" + times(30'000'000, "0", ",") + "],"); }, "accepted"},
      {"stack", "a name of fifty megabytes",
       [] {
         return stack_of(
             numbered(1, slice_of("{\"structure\":\"" + std::string(50u << 20, 'a') + "\",\"points\":[]}")));
       },
       "bad-name"},
      {"stack file", "a name of fifty megabytes",
       [] {
         return stack_of(
             numbered(1, slice_of("{\"structure\":\"" + std::string(50u << 20, 'a') + "\",\"points\":[]}")));
       },
       "too-large"},
      {"stack", "a height of ten million digits",
       [] { return stack_of("{\"z\":1" + std::string(10'000'000, '0') + ",\"contours\":[]}"); }, "not-finite"},
      {"stack", "a height of ten million decimals",
       [] { return stack_of("{\"z\":0." + std::string(10'000'000, '3') + ",\"contours\":[]}"); }, "accepted"},
      {"links", "a million links",
       [] {
         return "{\"format\":\"odontoscope.links\",\"version\":1,\"links\":[" +
                times(1'000'000, "{\"structure\":\"a\",\"slice\":0,\"lower\":0,\"upper\":1,\"connect\":true}", ",") +
                "]}";
       },
       "accepted"},
      {"scene",
       "as many keys as fit",
       [] { return "{\"format\":\"odontoscope.scene\",\"version\":1," + numbered(90'000, "\"#\":0") + "}"; },
       "accepted",
       {.seconds = 2}},
      {"scene", "as many structures as fit",
       [] {
         return "{\"format\":\"odontoscope.scene\",\"version\":1,\"structures\":[" +
                numbered(60'000, "{\"name\":\"#\"}") + "]}";
       },
       "bad-value"},
      {"scene", "a million brackets", [] { return "{\"deep\":" + times(1'000'000, "["); }, "too-deep"},
      {"notes", "a note too many",
       [] {
         return "{\"format\":\"odontoscope.tour\",\"version\":1,\"title\":\"\",\"notes\":[" +
                times(1001,
                      "{\"title\":\"\",\"text\":\"\",\"camera\":{\"position\":[0,0,9],\"target\":[0,0,8],\"up\":[0,1,0]"
                      "}}",
                      ",") +
                "]}";
       },
       "too-many-notes"},
      {"notes", "a million brackets", [] { return "{\"x-deep\":" + times(1'000'000, "{\"a\":"); }, "too-deep"},
      {"lesson", "as many keys as fit", [] { return "{" + numbered(24'000, "\"#\":0") + "}"; }, "unknown-key"},
      {"lesson", "as many brackets as fit", [] { return "{\"x-deep\":" + times(260'000, "["); }, "too-deep"},
      {"lesson", "a megabyte", [] { return times(1'000'000, " "); }, "file-too-large"},
      {"settings", "as many keys as fit",
       [] { return "{\"format\":\"odontoscope.viewer-settings\"," + numbered(6'500, "\"#\":0") + "}"; }, "accepted"},
      {"settings", "as many brackets as fit", [] { return times(65'000, "["); }, "accepted"},
      {"settings", "a hundred megabytes", [] { return std::string(100u << 20, ' '); }, "accepted"},
  };
}

// --- contours of other programs --------------------------------------------------------------------------------------

std::string section_with(const std::string& inner) {
  return "<Section index=\"1\" thickness=\"0.5\"><Transform dim=\"0\" xcoef=\"0 1 0 0 0 0\" ycoef=\"0 0 1 0 0 0\">" +
         inner + "</Transform></Section>";
}
const std::string trace = "<Contour name=\"a\" closed=\"true\" points=\"0 0,1 0,1 1\"/>";

std::string csl_plane(std::size_t vertices, const std::string& components, std::size_t count) {
  return "CSLC\n1 2\n1 " + std::to_string(vertices) + " " + std::to_string(count) + " 0 0 1 0\n" +
         times(vertices, "0 0 0\n") + components;
}

/// Undefined-length sequences, each in an item of the one before.
std::string nested_sequences(std::size_t depth) {
  std::string set = made::rtstruct({});
  set.resize(set.find("RTSTRUCT") + 8);
  const std::string sequence("\x06\x30\x20\x00SQ\0\0\xff\xff\xff\xff", 12), item("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8);
  return set + times(depth, sequence + item);
}

std::string set_of(std::size_t regions, std::size_t contours, const made::RoiContour& contour) {
  std::vector<made::RoiOfSet> rois(regions);
  for (std::size_t n = 0; n < regions; ++n)
    rois[n] = {"region " + std::to_string(n), std::vector<made::RoiContour>(contours, contour)};
  return made::rtstruct(rois);
}

std::vector<Large> contour_files() {
  return {
      {"csl", "planes that do not come", [] { return std::string("CSLC\n20000 2\n"); }, "truncated"},
      {"csl", "too many planes", [] { return std::string("CSLC\n20001 2\n"); }, "too-large"},
      {"csl", "too many components", [] { return csl_plane(3, "", limits::contours_per_slice + 1); }, "too-large"},
      {"csl", "two million vertices", [] { return csl_plane(2'000'000, "3 1 0 1 2\n", 1); }, "accepted"},
      {"csl", "a corner two million times", [] { return csl_plane(3, "2000000 1 " + times(2'000'000, "0 "), 1); },
       "accepted"},
      {"csl", "holes ten thousand deep",
       [] { return csl_plane(3, "3 1 0 1 2\n" + numbered(9'999, "3h# 1 0 1 2\n", ""), 10'000); }, "accepted"},
      {"csl", "a word of fifty megabytes", [] { return "CSLC\n" + std::string(50u << 20, '7'); }, "unparsable"},
      {"section", "ten thousand traces behind ten million lines",
       [] { return section_with(times(10'000'000, "\n") + times(10'000, trace)); }, "accepted"},
      {"section", "too many traces", [] { return section_with(times(limits::contours_per_slice + 1, trace)); },
       "too-many-contours"},
      {"section", "a million brackets", [] { return times(1'000'000, "<a>"); }, "unparsable"},
      {"section", "three million elements", [] { return section_with(times(3'000'000, "<a/>")); }, "accepted"},
      {"section", "nine million elements", [] { return section_with(times(9'000'000, "<a/>")); }, "file-too-large"},
      {"section", "nine million attributes", [] { return section_with("<a" + times(9'000'000, " b=''") + "/>"); },
       "file-too-large"},
      {"section", "a trace of two million points",
       [] { return section_with("<Contour name=\"a\" closed=\"true\" points=\"" + times(2'000'000, "0 1,") + "\"/>"); },
       "accepted"},
      {"section", "a name of fifty megabytes",
       [] {
         return section_with("<Contour closed=\"true\" points=\"\" name=\"" + std::string(50u << 20, 'a') + "\"/>");
       },
       "bad-name"},
      {"section", "an index of a million numbers",
       [] { return "<Section thickness=\"1\" index=\"" + times(1'000'000, "1 ") + "\"/>"; }, "unparsable"},
      {"series", "three million elements",
       [] { return "<Series units=\"mm\" defaultThickness=\"1\">" + times(3'000'000, "<a/>") + "</Series>"; },
       "accepted"},
      {"jser", "a million brackets", [] { return "{\"sections\":" + times(1'000'000, "["); }, "unparsable"},
      {"jser", "two million points in a trace",
       [] {
         const std::string numbers = "[" + times(2'000'000, "1", ",") + "]";
         return "{\"sections\":[{\"thickness\":1,\"contours\":{\"a\":[[" + numbers + "," + numbers +
                ",[0,0,0],true,false,false,[],[]]]}}],\"series\":{}}";
       },
       "accepted"},
      {"jser", "seventy million values", [] { return "{\"sections\":[" + times(70'000'000, "0", ",") + "]}"; },
       "file-too-large"},
      {"rtstruct", "sequences a hundred thousand deep", [] { return nested_sequences(100'000); },
       "unreadable-structure-set"},
      {"rtstruct", "too many regions", [] { return set_of(limits::structures + 1, 1, {}); }, "too-many-structures"},
      {"rtstruct", "too many contours in a plane", [] { return set_of(3, 5'000, {}); }, "too-many-contours"},
      {"rtstruct", "a thousand regions of nothing",
       [] { return set_of(1'000, 300, {.data = "", .count = "0", .type = "POINT"}); }, "accepted"},
      {"rtstruct", "two million points",
       [] { return set_of(1, 400, {.data = times(5'000, "1\\1\\1", "\\"), .count = "5000", .type = "CLOSED_PLANAR"}); },
       "accepted"},
  };
}

// --- meshes, volumes, pictures ---------------------------------------------------------------------------------------

std::string little_endian(std::uint32_t number) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &number, 4);
  return bytes;
}

std::string glb_of(std::string json, const std::string& more = "") {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(20 + json.size() + more.size())) +
         little_endian(static_cast<std::uint32_t>(json.size())) + "JSON" + json + more;
}

std::string triangles_drawn_by(std::size_t triangles, const std::string& nodes) {
  const std::string corners(36 * triangles, '\0'), count = std::to_string(3 * triangles),
                                                   bytes = std::to_string(corners.size());
  return glb_of("{\"nodes\":[" + nodes +
                    "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{"
                    "\"bufferView\":0,\"componentType\":5126,\"count\":" +
                    count + ",\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + bytes +
                    "}],\"buffers\":[{\"byteLength\":" + bytes + "}]}",
                little_endian(static_cast<std::uint32_t>(corners.size())) + std::string("BIN\0", 4) + corners);
}
std::string one_triangle_drawn_by(const std::string& nodes) { return triangles_drawn_by(1, nodes); }

std::string stl_facet() {
  return "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
}

/// There and back between two rows of so many vertices each: teeth of a comb, and its back.
std::string comb(int teeth) {
  std::string corners;
  for (int i = 1; i <= teeth; ++i) corners += " " + std::to_string(i + (i % 2 == 0 ? teeth : 0));
  return corners + " " + std::to_string(2 * teeth) + " " + std::to_string(teeth + 1);
}

/// A face back and forth between as many vertices, no three of which lie on a line.
std::string scribble(int corners, int vertices) {
  std::string text;
  for (int i = 0; i < vertices; ++i) text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
  text += "f";
  for (int i = 0; i < corners; ++i) text += " " + std::to_string(1 + i * 7919 % vertices);
  return text;
}

std::string big_endian(std::uint32_t number) {
  const std::string bytes = little_endian(number);
  return {bytes.rbegin(), bytes.rend()};
}

std::string png_header(std::uint32_t width, std::uint32_t height) {
  const std::string seed = seeds_of(reader("png")).front().bytes;
  return std::string(seed).replace(16, 8, big_endian(width) + big_endian(height));
}

std::string nrrd(const std::string& lines) {
  return "NRRD0004\ntype: uint8\ndimension: 3\nencoding: raw\n" + lines + "\n";
}

/// A DICOMDIR whose names come `times` each, one record after the other.
std::string directory_of(std::size_t records, std::size_t times) {
  std::vector<std::string> names;
  for (std::size_t n = 0; n < records; ++n) names.push_back("A\\" + std::to_string(n / times));
  return test::DicomDir{.records = test::records_of({{"1.2.3.4", names}})}.bytes();
}

std::vector<Large> mesh_files() {
  return {
      {"stl", "four thousand million triangles that do not come",
       [] { return std::string(80, ' ') + little_endian(0xffffffff); }, "truncated"},
      {"stl", "a million triangles",
       [] { return std::string(80, ' ') + little_endian(1'000'000) + std::string(50'000'000, '\0'); }, "accepted"},
      {"stl", "three hundred thousand triangles of text",
       [] { return "solid\n" + times(300'000, stl_facet()) + "endsolid\n"; }, "accepted"},
      {"stl", "a million empty solids", [] { return times(1'000'000, "solid\nendsolid\n"); }, "empty-mesh"},
      {"stl", "a word of fifty megabytes", [] { return "solid\n" + std::string(50u << 20, 'a'); }, "unparsable"},
      {"ply", "a header of two hundred thousand elements",
       [] {
         return "ply\nformat ascii 1.0\n" + numbered(200'000, "element e# 0\nproperty int a\n", "") + "end_header\n";
       },
       "empty-mesh"},
      {"ply", "an element of two hundred thousand properties",
       [] {
         return "ply\nformat ascii 1.0\nelement vertex 0\n" + numbered(200'000, "property int p#\n", "") +
                "end_header\n";
       },
       "bad-header"},
      {"ply", "a million comments",
       [] { return "ply\nformat ascii 1.0\n" + times(1'000'000, "comment a\n") + "end_header\n"; }, "empty-mesh"},
      {"ply", "a list of four thousand million",
       [] {
         return std::string(
                    "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int "
                    "vertex_indices\nend_header\n") +
                std::string(4, '\xff') + std::string(12, '\0');
       },
       "truncated"},
      {"ply", "rows of nothing, without end",
       [] { return std::string("ply\nformat ascii 1.0\nelement e 100000000\nend_header\n"); }, "bad-header"},
      {"obj", "two million objects", [] { return times(2'000'000, "o a\n"); }, "empty-mesh"},
      {"obj", "a face of five million corners", [] { return "v 0 0 0\nf" + times(5'000'000, " 1") + "\n"; },
       "too-large"},
      {"obj", "a comb of twenty thousand corners",
       [] {
         return numbered(20'000, "v # 0 0\n", "") + numbered(20'000, "v # -9 0\n", "") + "f" + comb(20'000) + "\n";
       },
       "accepted"},
      {"obj", "a scribble of ninety thousand corners", [] { return scribble(90'000, 300) + "\n"; }, "accepted"},
      {"obj", "a line that goes on a million times",
       [] { return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + times(1'000'000, "\\\n") + "3\n"; }, "accepted"},
      {"ply", "a strip of three million corners",
       [] {
         return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                "z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                "0 0 0\n1 0 0\n0 1 0\n3000000 " +
                times(1'000'000, "0 1 2 ");
       },
       "accepted"},
      {"gltf", "a million brackets", [] { return times(1'000'000, "["); }, "unparsable"},
      {"gltf", "a buffer of fifty megabytes that nobody asks for",
       [] { return "{\"buffers\":[{\"byteLength\":1,\"uri\":\"data:;base64," + std::string(50u << 20, 'A') + "\"}]}"; },
       "empty-mesh"},
      {"obj", "two hundred thousand objects with a triangle",
       [] { return "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + times(200'000, "o a\nf 1 2 3\n"); }, "accepted"},
      {"obj", "a word of fifty megabytes", [] { return std::string(50u << 20, 'v'); }, "unparsable"},
      {"glb", "a million brackets", [] { return glb_of(times(1'000'000, "[")); }, "unparsable"},
      {"glb", "a million chunks of nothing",
       [] { return glb_of("{}", times(1'000'000, std::string(4, '\0') + "ABCD")); }, "empty-mesh"},
      {"glb", "a hundred thousand nodes that draw one triangle",
       [] { return one_triangle_drawn_by(times(100'000, "{\"mesh\":0}", ",")); }, "accepted"},
      {"glb", "a million nodes that draw one triangle",
       [] { return one_triangle_drawn_by(times(1'000'000, "{\"mesh\":0}", ",")); }, "cannot be read"},
      {"glb", "ninety thousand nodes that draw a thousand triangles",
       [] { return triangles_drawn_by(1'000, times(90'000, "{\"mesh\":0}", ",")); }, "cannot be read"},
      {"glb", "two hundred thousand nodes that draw a thousand triangles",
       [] { return triangles_drawn_by(1'000, times(200'000, "{\"mesh\":0}", ",")); }, "too-large"},
      {"glb", "a chain of a hundred thousand nodes",
       [] { return one_triangle_drawn_by("{\"mesh\":0}," + numbered(100'000, "{\"children\":[#]}")); }, "accepted"},
      {"glb", "a node with a hundred thousand children that are one",
       [] { return one_triangle_drawn_by("{\"mesh\":0},{\"children\":[" + times(100'000, "0", ",") + "]}"); },
       "bad-node-tree"},
      {"volume", "a line of two megabytes", [] { return nrrd("sizes: " + std::string(2u << 20, '1') + "\n"); },
       "unreadable-volume"},
      {"volume", "a hundred thousand fields",
       [] { return nrrd("sizes: 2 2 2\n" + numbered(100'000, "key#:=value\n", "")) + std::string(8, '\0'); },
       "unreadable-volume"},
      {"volume", "more voxels than there are", [] { return nrrd("sizes: 100000 100000 100000\n"); }, "too-many-voxels"},
      {"volume", "as many voxels as are allowed, without one of them", [] { return nrrd("sizes: 1024 1024 1024\n"); },
       "truncated-volume"},
      {"volume", "pixels in a device that never ends",
       [] { return nrrd("sizes: 1024 1024 1024\ndata file: /dev/zero\n"); }, "outside-folder"},
      {"volume", "a directory of more names than are looked for",
       [] { return directory_of(limits::dicom_files + 1, 1); }, "too-many-files"},
      {"volume", "a directory of a quarter of a million records of one name",
       [] { return directory_of(250'000, 250'000); }, "no-dicom-images"},
      {"volume", "a directory of a million records", [] { return directory_of(1'000'000, 1'000'000); },
       "unreadable-volume"},
      {"png", "as large as is allowed, without a pixel", [] { return png_header(16'384, 16'384); }, "not-a-png"},
      {"png", "larger than is allowed", [] { return png_header(0x7fffffff, 0x7fffffff); }, "picture-too-large"},
  };
}

class LargeFile : public ::testing::TestWithParam<Large> {};

TEST_P(LargeFile, EndsWithinBounds) {
  const Large& large = GetParam();
  const std::string bytes = large.make();
  EXPECT_EQ(outcome_within(large.bounds, [&] { reader(large.reader).read(bytes); }), large.outcome) << large.what;
}

std::string name_of(const ::testing::TestParamInfo<Large>& file) {
  std::string name = file.param.reader + " " + file.param.what;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Json, LargeFile, ::testing::ValuesIn(json_files()), name_of);
INSTANTIATE_TEST_SUITE_P(Contours, LargeFile, ::testing::ValuesIn(contour_files()), name_of);
INSTANTIATE_TEST_SUITE_P(Meshes, LargeFile, ::testing::ValuesIn(mesh_files()), name_of);

}  // namespace
}  // namespace odontoscope::hostile
