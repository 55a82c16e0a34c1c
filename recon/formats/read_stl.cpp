#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "recon/core/limits.h"
#include "recon/formats/parsing.h"
#include "recon/formats/read_mesh.h"
#include "recon/mesh/part_walls.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

using namespace parsing;

constexpr std::size_t stl_header_size = 80, count_size = 4, record_size = 50, normal_size = 12;

void add_triangle(SurfaceMesh& soup, const Point3 (&corners)[3]) {
  const auto first = static_cast<PointIndex>(soup.points.size());
  soup.points.insert(soup.points.end(), corners, corners + 3);
  soup.triangles.push_back({first, first + 1, first + 2});
}

std::vector<NamedMesh> parse_binary(std::string_view bytes, const std::string& file) {
  const std::size_t count = little_endian<std::uint32_t>(bytes, stl_header_size);
  if (count > limits::triangles) {
    refuse("too-large", at_byte(file, stl_header_size),
           fmt::format("{} triangles are more than {}", count, limits::triangles));
  }
  SurfaceMesh soup;
  soup.points.reserve(3 * count);
  soup.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t record = stl_header_size + count_size + t * record_size;
    Point3 corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = record + normal_size + k * 3 * sizeof(float);
      corners[k] = {little_endian<float>(bytes, at), little_endian<float>(bytes, at + sizeof(float)),
                    little_endian<float>(bytes, at + 2 * sizeof(float))};
      const std::string_view fault = coordinate_fault(corners[k]);
      if (!fault.empty()) {
        refuse(fault, at_byte(file, at), fmt::format("corner {} of triangle {} has no usable coordinates", k, t));
      }
    }
    add_triangle(soup, corners);
  }
  std::vector<NamedMesh> meshes;
  meshes.push_back({"", weld(soup)});
  return meshes;
}

/// The words of a facet, one expected after the other.
class StlTextReader {
 public:
  StlTextReader(std::string_view text, const std::string& file) : words_(text, 1), file_(file) {}

  std::vector<NamedMesh> solids() {
    std::vector<NamedMesh> meshes;
    for (std::string_view word = words_.next(); !word.empty();) {
      if (!same_word(word, "solid")) unexpected(word, "solid");
      NamedMesh mesh{tame(words_.rest_of_line()), {}};
      SurfaceMesh soup;
      word = facets(soup);
      if (same_word(word, "endsolid")) {
        words_.rest_of_line();  // the name again
        word = words_.next();
      } else if (!soup.triangles.empty()) {
        mesh.remarks.push_back("\"endsolid\" is missing at its end");
      }
      if (soup.triangles.empty()) continue;
      mesh.surface = weld(soup);
      meshes.push_back(std::move(mesh));
    }
    return meshes;
  }

 private:
  /// Returns the word behind the last one: "endsolid", or, where that is missing, the next "solid" or nothing.
  std::string_view facets(SurfaceMesh& soup) {
    for (;;) {
      const std::string_view word = words_.next();
      const bool cut_off = soup.triangles.empty() && word.empty();
      if (!cut_off && (word.empty() || same_word(word, "endsolid") || same_word(word, "solid"))) return word;
      if (!same_word(word, "facet")) unexpected(word, "facet or endsolid");
      if (triangles_++ == limits::triangles) {
        refuse("too-large", at_line(file_, words_.line()),
               fmt::format("there are more than {} triangles", limits::triangles));
      }
      expect("normal");
      for (int i = 0; i < 3; ++i) number();
      expect("outer");
      expect("loop");
      Point3 corners[3];
      for (Point3& corner : corners) corner = vertex();
      expect("endloop");
      expect("endfacet");
      add_triangle(soup, corners);
    }
  }

  Point3 vertex() {
    expect("vertex");
    Point3 point;
    point.x = number();
    point.y = number();
    point.z = number();
    const std::string_view fault = coordinate_fault(point);
    if (!fault.empty()) refuse(fault, at_line(file_, words_.line()), "a vertex has no usable coordinates");
    return point;
  }

  double number() {
    const std::string_view word = words_.next();
    double value = 0;
    if (!parse_number(word, value)) unexpected(word, "a number");
    return value;
  }

  void expect(std::string_view wanted) {
    const std::string_view word = words_.next();
    if (!same_word(word, wanted)) unexpected(word, wanted);
  }

  [[noreturn]] void unexpected(std::string_view word, std::string_view wanted) {
    if (word.empty()) {
      refuse("truncated", at_line(file_, words_.line()), fmt::format("the file ends where {} should come", wanted),
             "Copy or export it again");
    }
    refuse("unparsable", at_line(file_, words_.line()),
           fmt::format("\"{}\" stands where {} should", tame(word.substr(0, limits::quoted_length)), wanted));
  }

  Words words_;
  const std::string& file_;
  std::size_t triangles_ = 0;
};

/// Many binary files begin with "solid", too, but no text has zeros, which counts and unused attributes are full of.
bool is_text(std::string_view bytes) {
  Words words(bytes.substr(0, stl_header_size), 1);
  return same_word(words.next(), "solid") &&
         bytes.substr(0, stl_header_size + count_size + record_size).find('\0') == bytes.npos;
}

}  // namespace

std::vector<NamedMesh> parse_stl(std::string_view bytes, const std::string& file) {
  // The size tells a binary file for sure; many begin with "solid", as an ASCII file must.
  const bool has_count = bytes.size() >= stl_header_size + count_size;
  const std::size_t announced =
      has_count ? stl_header_size + count_size +
                      record_size * std::size_t{little_endian<std::uint32_t>(bytes, stl_header_size)}
                : 0;
  const bool text = bytes.size() != announced && is_text(bytes);
  if (!text && !has_count) {
    refuse(bytes.empty() ? "empty-mesh" : "truncated", at_byte(file, bytes.size()),
           "the file is too short to be an STL file", "Copy or export it again");
  }
  if (!text && bytes.size() < announced) {
    refuse("truncated", at_byte(file, bytes.size()),
           fmt::format("its header announces {} bytes, and it has {}", announced, bytes.size()),
           "Copy or export it again");
  }
  std::vector<NamedMesh> meshes = text ? StlTextReader(bytes, file).solids() : parse_binary(bytes, file);
  if (!text && bytes.size() > announced) meshes.front().remarks.push_back(bytes_behind_told(bytes.size() - announced));
  std::size_t triangles = 0;
  for (NamedMesh& mesh : meshes) {
    triangles += mesh.surface.triangles.size();
    part_walls_told(mesh);
  }
  if (triangles == 0) refuse("empty-mesh", at_byte(file, 0), "the file holds no triangle");
  return meshes;
}

}  // namespace odontoscope
