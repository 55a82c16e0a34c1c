#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "recon/core/limits.h"
#include "recon/formats/face_list.h"
#include "recon/formats/join_seams.h"
#include "recon/formats/parsing.h"
#include "recon/formats/read_mesh.h"

namespace odontoscope {
namespace {

using namespace parsing;

enum class Encoding { ascii, little, big };
enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

constexpr std::size_t size_of(Type type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}
constexpr bool is_whole(Type type) { return type != Type::f32 && type != Type::f64; }

std::optional<Type> type_named(std::string_view word) {
  constexpr std::pair<std::string_view, Type> names[] = {
      {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
      {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
      {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
      {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
  for (const auto& [name, type] : names) {
    if (name == word) return type;
  }
  return std::nullopt;
}

struct Property {
  std::string name;
  Type type = Type::f32;
  std::optional<Type> count_type;  // of a list
};

struct Element {
  std::string name;
  std::size_t count = 0, line = 0;
  std::vector<Property> properties;
  /// Bytes that one row takes at least: in text a digit and a blank a value (the very last may lack the blank).
  std::size_t least_size(Encoding encoding) const {
    std::size_t size = 0;
    for (const Property& p : properties) {
      size += encoding == Encoding::ascii ? 2 : size_of(p.count_type.value_or(p.type));
    }
    return size;
  }
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  std::size_t size = 0, lines = 0;
};

/// Line after line of the header.
class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  Header read() {
    if (next_line() != "ply") refuse("bad-header", "the file does not begin with the line \"ply\"");
    bool has_format = false;
    for (;;) {
      const std::string_view line = next_line();
      Words words(line, header_.lines);
      const std::string_view keyword = words.next();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        read_format(words);
        has_format = true;
      } else if (keyword == "element") {
        read_element(words);
      } else if (keyword == "property") {
        read_property(words);
      } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
        refuse("bad-header",
               fmt::format("\"{}\" means nothing in a PLY header", tame(keyword.substr(0, limits::quoted_length))));
      }
    }
    if (!has_format) refuse("bad-header", "the header has no format line");
    return std::move(header_);
  }

 private:
  std::string_view next_line() {
    const std::size_t first = header_.size, end = line_end(bytes_.substr(0, first + limits::text_line + 1), first);
    const bool ends = end < bytes_.size() && end - first <= limits::text_line;
    ++header_.lines;
    if (!ends) {
      const bool ply = first != 0;
      refuse(ply && end == bytes_.size() ? "truncated" : "bad-header",
             ply ? "the header does not end" : "the file does not begin with the line \"ply\"");
    }
    // All lines end as the first one does: behind a CR by itself, an LF may be the first number.
    if (first == 0) lone_cr_ = bytes_[end] == '\r' && parsing::next_line(bytes_, end) == end + 1;
    header_.size = lone_cr_ ? end + 1 : parsing::next_line(bytes_, end);
    std::string_view line = bytes_.substr(first, end - first);
    while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
    return line;
  }

  void read_format(Words& words) {
    const std::string_view name = words.next(), version = words.next();
    if (name == "ascii")
      header_.encoding = Encoding::ascii;
    else if (name == "binary_little_endian")
      header_.encoding = Encoding::little;
    else if (name == "binary_big_endian")
      header_.encoding = Encoding::big;
    else
      refuse("bad-header", fmt::format("\"{}\" is no PLY format", tame(name.substr(0, limits::quoted_length))));
    if (version != "1.0") refuse("bad-header", "the PLY version is not 1.0");
  }

  void read_element(Words& words) {
    Element element;
    element.line = header_.lines;
    element.name = words.next();
    double count = -1;
    const bool number = parse_number(words.next(), count);
    if (element.name.empty() || !number || !(count >= 0) || count > 9e15 || count != std::floor(count)) {
      refuse("bad-header", "an element needs a name and a count");
    }
    element.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void read_property(Words& words) {
    if (header_.elements.empty()) refuse("bad-header", "a property comes before any element");
    Property property;
    std::string_view word = words.next();
    if (word == "list") {
      property.count_type = type_named(words.next());
      if (!property.count_type || !is_whole(*property.count_type))
        refuse("bad-header", "a list needs a whole-number count type");
      word = words.next();
    }
    const std::optional<Type> type = type_named(word);
    property.name = words.next();
    if (!type || property.name.empty()) refuse("bad-header", "a property needs a type and a name");
    property.type = *type;
    header_.elements.back().properties.push_back(std::move(property));
  }

  [[noreturn]] void refuse(std::string_view cause, std::string_view wrong) {
    parsing::refuse(cause, at_line(file_, header_.lines), wrong, "Export it again as PLY 1.0");
  }

  std::string_view bytes_;
  const std::string& file_;
  Header header_;
  bool lone_cr_ = false;
};

/// The numbers behind the header, whatever their encoding.
class Body {
 public:
  Body(std::string_view bytes, const Header& header, const std::string& file)
      : bytes_(bytes),
        file_(file),
        encoding_(header.encoding),
        at_(header.size),
        words_(bytes.substr(header.size), header.lines + 1) {}

  double number(Type type) {
    if (encoding_ == Encoding::ascii) return word(type);
    const std::size_t size = size_of(type);
    if (size > bytes_.size() - at_) truncated();
    std::array<char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, size);
    if (encoding_ == Encoding::big) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    at_ += size;
    return decoded(std::string_view(raw.data(), raw.size()), type);
  }

  /// Of a list; never more than can be there.
  std::size_t list_length(const Property& property) {
    const double length = number(*property.count_type);
    if (!(length >= 0) || length != std::floor(length)) refuse("unparsable", "a list has no sensible length");
    const std::size_t least = encoding_ == Encoding::ascii ? 1 : size_of(property.type);
    const std::size_t most = left() / least;
    if (length > static_cast<double>(most)) truncated();
    return static_cast<std::size_t>(length);
  }

  void skip(const Property& property) {
    const std::size_t values = property.count_type ? list_length(property) : 1;
    for (std::size_t i = 0; i < values; ++i) number(property.type);
  }

  std::size_t left() const { return encoding_ == Encoding::ascii ? words_.left() : bytes_.size() - at_; }

  [[noreturn]] void refuse(std::string_view cause, std::string_view wrong, std::string_view remedy = {}) {
    const bool text = encoding_ == Encoding::ascii;
    parsing::refuse(cause, text ? at_line(file_, words_.line()) : at_byte(file_, at_), wrong, remedy);
  }
  [[noreturn]] void truncated() {
    refuse("truncated", "the file ends before the elements that its header announces", "Copy or export it again");
  }
  /// How many bytes follow what the header announces. Of text there must be none: a count may have been mistyped.
  std::size_t bytes_behind() {
    if (encoding_ != Encoding::ascii) return bytes_.size() - at_;
    if (!words_.next().empty())
      refuse("trailing-bytes", "the file goes on after the elements that its header announces",
             "Correct the counts in its header");
    return 0;
  }

 private:
  double word(Type type) {
    const std::string_view text = words_.next();
    if (text.empty()) truncated();
    double value = 0;
    if (!parse_number(text, value) || (is_whole(type) && value != std::floor(value))) {
      refuse("unparsable",
             fmt::format("\"{}\" is no number of the announced type", tame(text.substr(0, limits::quoted_length))));
    }
    return value;
  }

  static double decoded(std::string_view raw, Type type) {
    switch (type) {
      case Type::i8:
        return little_endian<std::int8_t>(raw, 0);
      case Type::u8:
        return little_endian<std::uint8_t>(raw, 0);
      case Type::i16:
        return little_endian<std::int16_t>(raw, 0);
      case Type::u16:
        return little_endian<std::uint16_t>(raw, 0);
      case Type::i32:
        return little_endian<std::int32_t>(raw, 0);
      case Type::u32:
        return little_endian<std::uint32_t>(raw, 0);
      case Type::f32:
        return little_endian<float>(raw, 0);
      case Type::f64:
        return little_endian<double>(raw, 0);
    }
    throw InternalError("no such PLY type");
  }

  std::string_view bytes_;
  const std::string& file_;
  Encoding encoding_;
  std::size_t at_;
  Words words_;
};

std::vector<Point3> read_vertices(Body& body, const Element& element) {
  int axis_of[3] = {-1, -1, -1};
  constexpr std::string_view axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Property& p = element.properties[i];
      if (p.name == axes[axis] && !p.count_type) axis_of[axis] = static_cast<int>(i);
    }
  }
  if (std::count(axis_of, axis_of + 3, -1) != 0) body.refuse("bad-header", "the vertices have no x, y and z");
  std::vector<Point3> points;
  points.reserve(element.count);
  for (std::size_t row = 0; row < element.count; ++row) {
    Point3 point;
    for (int i = 0; i < static_cast<int>(element.properties.size()); ++i) {
      const Property& p = element.properties[static_cast<std::size_t>(i)];
      if (i == axis_of[0])
        point.x = body.number(p.type);
      else if (i == axis_of[1])
        point.y = body.number(p.type);
      else if (i == axis_of[2])
        point.z = body.number(p.type);
      else
        body.skip(p);
    }
    const std::string_view fault = coordinate_fault(point);
    if (!fault.empty()) body.refuse(fault, fmt::format("vertex {} has no usable coordinates", row));
    points.push_back(point);
  }
  return points;
}

/// Corners of a face, or of strips, where -1 ends one.
class CornerList {
 public:
  CornerList(Body& body, const Element& element, std::string_view what) : body_(body), what_(what) {
    list_ = std::find_if(element.properties.begin(), element.properties.end(), [](const Property& p) {
      return p.count_type && is_whole(p.type) && (p.name == "vertex_indices" || p.name == "vertex_index");
    });
    if (list_ == element.properties.end())
      body.refuse("bad-header", fmt::format("the {}s have no list vertex_indices", what));
  }

  /// Reads the row; calls `take` with the corners of each piece.
  template <class Take>
  void read_row(const Element& element, std::size_t row, std::size_t points, bool pieces, Take take) {
    for (auto p = element.properties.begin(); p != element.properties.end(); ++p) {
      if (p != list_) {
        body_.skip(*p);
        continue;
      }
      const std::size_t count = body_.list_length(*p);
      corners_.clear();
      for (std::size_t i = 0; i < count; ++i) {
        const double index = body_.number(p->type);
        if (pieces && index == -1) {
          take(corners_);
          corners_.clear();
          continue;
        }
        if (!(index >= 0) || !(index < static_cast<double>(points))) {
          body_.refuse("index-out-of-range", fmt::format("{} {} names vertex {} of {}", what_, row, index, points));
        }
        corners_.push_back(static_cast<PointIndex>(index));
      }
      take(corners_);
    }
  }

  [[noreturn]] void too_large(std::string_view wrong) { body_.refuse("too-large", wrong); }

 private:
  Body& body_;
  std::string_view what_;
  std::vector<Property>::const_iterator list_;
  std::vector<PointIndex> corners_;
};

/// `points`: how many there are, or may be where they come behind the faces.
void read_faces(Body& body, const Element& element, std::size_t points, bool strips, FaceList& faces) {
  CornerList corners(body, element, strips ? "strip" : "face");
  for (std::size_t row = 0; row < element.count; ++row) {
    corners.read_row(element, row, points, strips, [&](const std::vector<PointIndex>& piece) {
      if (!strips && piece.size() > limits::polygon_corners)
        corners.too_large(fmt::format("face {} has more than {} corners", row, limits::polygon_corners));
      if (strips)
        faces.add_strip(piece);
      else
        faces.add(piece);
      if (faces.triangles() > limits::triangles)
        corners.too_large(fmt::format("there are more than {} triangles", limits::triangles));
    });
  }
}

void check_count(const Element& element, const Header& header, const Body& body, const std::string& file) {
  const std::size_t least = element.least_size(header.encoding);
  if (least == 0) {
    if (element.count != 0) refuse("bad-header", at_line(file, element.line), "an element has no property");
    return;
  }
  // One more for the blank that the last value of a text may lack.
  if (element.count > (body.left() + 1) / least) {
    refuse("truncated", at_line(file, element.line),
           fmt::format("{} rows of \"{}\" do not fit into the {} bytes that are left", element.count,
                       tame(element.name), body.left()),
           "Copy or export it again");
  }
  if (element.count > limits::triangles) {
    refuse("too-large", at_line(file, element.line), fmt::format("more than {} rows", limits::triangles));
  }
}

}  // namespace

std::vector<NamedMesh> parse_ply(std::string_view bytes, const std::string& file) {
  const Header header = HeaderReader(bytes, file).read();
  Body body(bytes, header, file);
  NamedMesh mesh;
  FaceList faces;
  for (const Element& element : header.elements) {
    check_count(element, header, body, file);
    if (element.name == "vertex" && mesh.surface.points.empty()) {
      mesh.surface.points = read_vertices(body, element);
    } else if (element.name == "face" || element.name == "tristrips") {
      const std::size_t points = mesh.surface.points.empty() ? 3 * limits::triangles : mesh.surface.points.size();
      read_faces(body, element, points, element.name == "tristrips", faces);
    } else {
      for (std::size_t row = 0; row < element.count; ++row) {
        for (const Property& p : element.properties) body.skip(p);
      }
    }
  }
  const std::size_t behind = body.bytes_behind();
  if (faces.empty()) refuse("empty-mesh", at_byte(file, header.size), "the file holds no triangle");
  if (faces.largest_corner() >= mesh.surface.points.size()) {
    refuse("index-out-of-range", at_byte(file, header.size),
           fmt::format("a face names vertex {} of {}", faces.largest_corner(), mesh.surface.points.size()));
  }
  faces.cut_into(mesh.surface);
  mesh.remarks = faces.remarks();
  if (behind > 0) mesh.remarks.push_back(bytes_behind_told(behind));
  join_seams_told(mesh);
  std::vector<NamedMesh> meshes;
  meshes.push_back(std::move(mesh));
  return meshes;
}

}  // namespace odontoscope
