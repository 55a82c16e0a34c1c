#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "recon/core/limits.h"
#include "recon/formats/face_list.h"
#include "recon/formats/join_seams.h"
#include "recon/formats/parsing.h"
#include "recon/formats/read_mesh.h"

namespace odontoscope {
namespace {

using namespace parsing;

/// An object at hand: its faces in the file's numbers become its own.
struct Object {
  std::string name;
  std::vector<Point3> points;
  FaceList faces;
  std::unordered_map<std::size_t, PointIndex> number;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<NamedMesh> meshes() {
    while (next_line()) read_line();
    finish_object();
    return std::move(meshes_);
  }

 private:
  /// Lines that end with a backslash go on in the next one, but for comments.
  bool next_line() {
    if (at_ >= text_.size()) return false;
    number_ = next_number_;
    line_ = piece_of_line();
    if (!goes_on() || line_.find_first_not_of(" \t") == line_.find('#')) return true;
    joined_.clear();
    for (;;) {
      joined_.append(line_.substr(0, line_.rfind('\\'))).push_back(' ');
      if (at_ >= text_.size()) break;
      line_ = piece_of_line();
      if (goes_on()) continue;
      joined_.append(line_);
      break;
    }
    line_ = joined_;
    return true;
  }

  std::string_view piece_of_line() {
    const std::size_t end = line_end(text_, at_);
    const std::string_view piece = text_.substr(at_, end - at_);
    at_ = parsing::next_line(text_, end);
    ++next_number_;
    return piece;
  }

  bool goes_on() const {
    const std::size_t last = line_.find_last_not_of(" \t");
    return last != line_.npos && line_[last] == '\\';
  }

  void read_line() {
    Words words(line_, number_);
    const std::string_view keyword = words.next();
    if (keyword == "v")
      read_vertex(words);
    else if (keyword == "f" || keyword == "fo")
      read_face(words);
    else if (keyword == "o")
      begin_object(tame(words.rest_of_line()));
    else if (keyword.empty() || keyword.front() == '#')
      return;
    else if (is_curved(keyword)) {
      fail("unsupported", fmt::format("\"{}\" is of free-form curves and surfaces", keyword), "Export it as polygons");
    } else if (!is_skipped(keyword)) {
      fail("unparsable",
           fmt::format("\"{}\" is no word of an OBJ file", tame(keyword.substr(0, limits::quoted_length))));
    }
  }

  /// Normals, textures, materials, groups, lines, points and ways to draw, which bound nothing.
  static bool is_skipped(std::string_view keyword) {
    for (const std::string_view known : {"vn", "vt", "vp", "g", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "l",
                                         "p", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"}) {
      if (keyword == known) return true;
    }
    return false;
  }
  static bool is_curved(std::string_view keyword) {
    for (const std::string_view known :
         {"cstype", "deg", "bmat", "step",  "curv",  "curv2", "surf", "parm", "trim", "hole", "scrv",
          "sp",     "end", "con",  "ctech", "stech", "res",   "bzp",  "bsp",  "cdc",  "cdp"}) {
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
    corners_.clear();
    for (std::string_view word = words.next(); !word.empty() && word.front() != '#'; word = words.next()) {
      if (corners_.size() == limits::polygon_corners)
        fail("too-large", fmt::format("a face has more than {} corners", limits::polygon_corners));
      const std::size_t vertex = vertex_number(word);
      const auto [at, fresh] = object_.number.try_emplace(vertex, static_cast<PointIndex>(object_.points.size()));
      if (fresh) object_.points.push_back(points_[vertex]);
      corners_.push_back(at->second);
    }
    object_.faces.add(corners_);
    if (triangles_ + object_.faces.triangles() > limits::triangles)
      fail("too-large", fmt::format("there are more than {} triangles", limits::triangles));
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
    triangles_ += object_.faces.triangles();
    if (!object_.faces.empty()) {
      NamedMesh mesh{std::move(object_.name), {std::move(object_.points), {}}};
      object_.faces.cut_into(mesh.surface);
      mesh.remarks = object_.faces.remarks();
      join_seams_told(mesh);
      meshes_.push_back(std::move(mesh));
    }
    object_ = {};
  }

  [[noreturn]] void fail(std::string_view cause, std::string_view wrong, std::string_view remedy = {}) const {
    refuse(cause, at_line(file_, number_), wrong, remedy);
  }

  std::string_view text_, line_;
  const std::string& file_;
  std::string joined_;  // a line that goes on
  std::size_t at_ = 0, number_ = 0, next_number_ = 1, triangles_ = 0;
  std::vector<PointIndex> corners_;
  std::vector<Point3> points_;
  Object object_;
  std::vector<NamedMesh> meshes_;
};

}  // namespace

std::vector<NamedMesh> parse_obj(std::string_view bytes, const std::string& file) {
  std::vector<NamedMesh> meshes = ObjReader(bytes, file).meshes();
  if (meshes.empty()) refuse("empty-mesh", at_line(file, 1), "the file holds no triangle");
  return meshes;
}

}  // namespace odontoscope
