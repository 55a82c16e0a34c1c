#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "recon/core/limits.h"
#include "recon/mesh/parsing.h"
#include "recon/mesh/read_mesh.h"

namespace odontoscope {
namespace {

using namespace parsing;

/// An object at hand: its triangles in the file's numbers become its own.
struct Object {
  std::string name;
  SurfaceMesh surface;
  std::unordered_map<std::size_t, PointIndex> number;
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<NamedMesh> meshes() {
    while (next_line()) read_line();
    finish_object();
    return std::move(meshes_);
  }

 private:
  bool next_line() {
    if (at_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    line_ = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++number_;
    return true;
  }

  void read_line() {
    Words words(line_, number_);
    const std::string_view keyword = words.next();
    if (keyword == "v") read_vertex(words);
    else if (keyword == "f") read_face(words);
    else if (keyword == "o") begin_object(tame(words.rest_of_line()));
    else if (keyword.empty() || keyword.front() == '#') return;
    else if (!is_skipped(keyword)) {
      fail("unparsable", fmt::format("\"{}\" is no word of an OBJ file", tame(keyword.substr(0, limits::quoted_length))));
    }
  }

  /// Normals, textures, materials, groups, lines and points, which bound nothing.
  static bool is_skipped(std::string_view keyword) {
    for (const std::string_view known : {"vn", "vt", "vp", "g", "s", "mg", "usemtl", "mtllib", "usemap", "l", "p", "lod"}) {
      if (keyword == known) return true;
    }
    return false;
  }

  void read_vertex(Words& words) {
    double values[3];
    for (double& value : values) {
      const std::string_view word = words.next();
      if (word.empty()) fail("unparsable", "a vertex has three coordinates");
      if (!parse_number(word, value)) {
        fail("unparsable", fmt::format("\"{}\" is no number", tame(word.substr(0, limits::quoted_length))));
      }
    }
    const Point3 point{values[0], values[1], values[2]};
    const std::string_view fault = coordinate_fault(point);
    if (!fault.empty()) fail(fault, "a vertex has no usable coordinates");
    points_.push_back(point);
  }

  void read_face(Words& words) {
    std::size_t corners[3];
    std::size_t count = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      if (count < 3) corners[count] = vertex_number(word);
      ++count;
    }
    if (count != 3) fail("not-triangles", fmt::format("a face has {} corners", count), "Export it with triangles only");
    if (triangles_++ == limits::triangles) fail("too-large", fmt::format("there are more than {} triangles", limits::triangles));
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, fresh] = object_.number.try_emplace(corners[k], static_cast<PointIndex>(object_.surface.points.size()));
      if (fresh) object_.surface.points.push_back(points_[corners[k]]);
      triangle[k] = at->second;
    }
    object_.surface.triangles.push_back(triangle);
  }

  /// "7", "7/1", "7/1/2" or "7//2"; from 1, or below 0 back from the last one.
  std::size_t vertex_number(std::string_view word) {
    double value = 0;
    if (!parse_number(word.substr(0, word.find('/')), value) || value != std::floor(value)) {
      fail("unparsable", fmt::format("\"{}\" names no vertex", tame(word.substr(0, limits::quoted_length))));
    }
    const double known = static_cast<double>(points_.size()), index = value < 0 ? known + value : value - 1;
    if (!(index >= 0) || !(index < known)) {
      fail("index-out-of-range", fmt::format("a face names vertex {} of {}", value, points_.size()));
    }
    return static_cast<std::size_t>(index);
  }

  void begin_object(std::string name) {
    finish_object();
    object_.name = std::move(name);
  }
  void finish_object() {
    if (!object_.surface.triangles.empty()) meshes_.push_back({std::move(object_.name), std::move(object_.surface)});
    object_ = {};
  }

  [[noreturn]] void fail(std::string_view cause, std::string_view wrong, std::string_view remedy = {}) const {
    refuse(cause, at_line(file_, number_), wrong, remedy);
  }

  std::string_view text_, line_;
  const std::string& file_;
  std::size_t at_ = 0, number_ = 0, triangles_ = 0;
  std::vector<Point3> points_;
  Object object_;
  std::vector<NamedMesh> meshes_;
};

}  // namespace

std::vector<NamedMesh> parse_obj(std::string_view bytes, const std::string& file) {
  std::vector<NamedMesh> meshes = Reader(bytes, file).meshes();
  if (meshes.empty()) refuse("empty-mesh", at_line(file, 1), "the file holds no triangle");
  return meshes;
}

}  // namespace odontoscope
