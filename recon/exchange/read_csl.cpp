#include "recon/exchange/read_csl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "recon/core/limits.h"
#include "recon/exchange/limits.h"
#include "recon/exchange/plane_frame.h"
#include "recon/formats/parsing.h"
#include "recon/input/counts.h"

namespace odontoscope {
namespace {

using namespace parsing;

struct Component {
  std::size_t label = 0;
  std::size_t owner = 0;  // the component that it is a hole of, or itself
  std::vector<std::size_t> vertices;
};

struct Plane {
  Vector normal{};    // of length 1
  double offset = 0;  // of its points along the normal
  std::vector<Vector> vertices;
  std::vector<Component> components;
  std::size_t line = 0;
};

class CslReader {
 public:
  CslReader(std::string_view text, const std::string& file) : words_(text, 1), file_(file) {}

  std::vector<Plane> planes() {
    if (words_.next() != "CSLC") fail("bad-header", "the file does not begin with the line \"CSLC\"");
    const std::size_t count = number_up_to(limits::slices, "planes");
    labels_ = number_up_to(limits::structures, "labels");
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < count; ++i) planes.push_back(plane());
    if (!words_.next().empty()) fail("trailing-bytes", "the file goes on after the planes that it announces");
    return planes;
  }

  std::size_t labels() const { return labels_; }

 private:
  Plane plane() {
    Plane plane;
    whole_number();  // of the plane
    plane.line = words_.line();
    const std::size_t vertices = number_up_to(limits::points, "vertices");
    const std::size_t components = number_up_to(limits::contours_per_slice, "components");
    const Vector normal{number(), number(), number()};
    const double size = length(normal), shift = number();
    if (!std::isnormal(size)) fail("unparsable", "a plane's A, B and C are no direction");
    plane.normal = {normal[0] / size, normal[1] / size, normal[2] / size};
    plane.offset = -shift / size;
    require_bytes(vertices, 6);  // three digits and blanks
    for (std::size_t i = 0; i < vertices; ++i) {
      const Point3 p{number(), number(), number()};
      const std::string_view fault = coordinate_fault(p);
      if (!fault.empty()) fail(fault, fmt::format("vertex {} has no usable coordinates", i));
      plane.vertices.push_back({p.x, p.y, p.z});
    }
    for (std::size_t i = 0; i < components; ++i) plane.components.push_back(component(vertices, i, components));
    resolve_owners(plane.components);
    return plane;
  }

  Component component(std::size_t vertices, std::size_t number, std::size_t components) {
    Component component;
    component.owner = number;
    std::string_view word = words_.next();
    const std::size_t h = word.find('h');
    const std::size_t count = whole(word.substr(0, h));
    if (h != word.npos) {
      const std::size_t other = whole(word.substr(h + 1));
      if (other >= components)
        fail("index-out-of-range", fmt::format("a hole of component {} of {}", other, components));
      if (other == number) fail("index-out-of-range", fmt::format("component {} is a hole of itself", number));
      component.owner = other;  // which may come later
    }
    component.label = whole_number();
    require_bytes(count, 2);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t vertex = whole_number();
      if (vertex >= vertices)
        fail("index-out-of-range", fmt::format("a component names vertex {} of {}", vertex, vertices));
      component.vertices.push_back(vertex);
    }
    return component;
  }

  /// A hole of a hole belongs to what that is a hole of.
  void resolve_owners(std::vector<Component>& components) {
    std::vector<std::size_t> way;
    std::vector<char> settled(components.size(), 0);
    for (std::size_t i = 0; i < components.size(); ++i) {
      std::size_t at = i;
      for (way.clear(); !settled[at] && components[at].owner != at; at = components[at].owner) {
        way.push_back(at);
        if (way.size() > components.size())
          fail("index-out-of-range", fmt::format("component {} is a hole of its own hole", i));
      }
      const std::size_t owner = components[at].owner;
      for (const std::size_t hole : way) components[hole].owner = owner;
      for (const std::size_t hole : way) settled[hole] = 1;
    }
  }

  double number() {
    const std::string_view word = words_.next();
    double value = 0;
    if (word.empty()) truncated();
    if (!parse_number(word, value)) not_a_number(word);
    if (!std::isfinite(value)) fail("not-finite", "NaN and infinity are not allowed");
    return value;
  }

  std::size_t whole_number() { return whole(words_.next()); }
  std::size_t whole(std::string_view word) {
    double value = 0;
    if (word.empty()) truncated();
    if (!parse_number(word, value) || value != std::floor(value) || value < 0 || value > 1e15) not_a_number(word);
    return static_cast<std::size_t>(value);
  }

  std::size_t number_up_to(std::size_t most, std::string_view what) {
    const std::size_t value = whole_number();
    if (value > most) fail("too-large", fmt::format("{} {} are more than {}", value, what, most));
    return value;
  }

  /// `count` things of `least` bytes each are still to come; the last may lack its blank.
  void require_bytes(std::size_t count, std::size_t least) {
    if (count > (words_.left() + 1) / least) truncated();
  }

  [[noreturn]] void truncated() { fail("truncated", "the file ends before what it announces"); }
  [[noreturn]] void not_a_number(std::string_view word) {
    fail("unparsable", fmt::format("\"{}\" stands where a number should", tame(word.substr(0, limits::quoted_length))));
  }
  [[noreturn]] void fail(std::string_view cause, std::string_view wrong) {
    refuse(cause, at_line(file_, words_.line()), wrong, "Copy or export it again");
  }

  Words words_;
  const std::string& file_;
  std::size_t labels_ = 0;
};

/// Heights along the common normal, which is that of the first plane; planes must be parallel to it.
std::vector<double> heights_of(const std::vector<Plane>& planes, const Frame& frame, const std::string& file) {
  std::vector<double> heights;
  for (const Plane& plane : planes) {
    if (length(cross(plane.normal, frame.n)) > limits::out_of_parallel) {
      refuse("not-parallel", at_line(file, plane.line),
             fmt::format("plane {} is not parallel to the first", heights.size()),
             "Only parallel planes can be reconstructed");
    }
    heights.push_back((dot(plane.normal, frame.n) > 0 ? plane.offset : -plane.offset) + 0.0);  // never -0
  }
  return heights;
}

double least_distance(std::vector<double> heights) {
  std::sort(heights.begin(), heights.end());
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < heights.size(); ++i) least = std::min(least, heights[i] - heights[i - 1]);
  return least;
}

Slice slice_of(const Plane& plane, double height, const Frame& frame, double allowed, std::size_t labels,
               const std::string& file, double& farthest) {
  for (const Vector& vertex : plane.vertices) {
    const double off = std::abs(dot(vertex, frame.n) - height);
    farthest = std::max(farthest, off);
    if (off > allowed) {
      refuse("off-plane", at_line(file, plane.line),
             fmt::format("a point lies {:.3g} off the plane that it is said to be in", off),
             "Correct the plane or the point");
    }
  }
  Slice slice{height, {}};
  for (const Component& component : plane.components) {
    Contour contour;
    contour.structure = labels <= 2 ? "tooth" : fmt::format("label {}", plane.components[component.owner].label);
    for (const std::size_t v : component.vertices)
      contour.points.push_back({dot(plane.vertices[v], frame.u), dot(plane.vertices[v], frame.v)});
    slice.contours.push_back(std::move(contour));
  }
  return slice;
}

}  // namespace

bool looks_like_csl(std::string_view bytes) {
  return bytes.starts_with("CSLC") && bytes.size() > 4 && is_space(bytes[4]);
}

FileContours parse_csl(std::string_view bytes, const std::string& file) {
  CslReader reader(bytes, file);
  const std::vector<Plane> planes = reader.planes();
  FileContours result;
  result.stack.source = file;
  if (planes.empty()) return result;
  const Frame frame = frame_of(planes.front().normal);
  const std::vector<double> heights = heights_of(planes, frame, file);
  const double least = least_distance(heights);
  if (!(least > 0)) refuse("repeated-z", at_line(file, 2), "two planes lie at the same height", "Merge the two");
  double farthest = 0;
  std::size_t contours = 0, points = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    check_magnitude(heights[i], "z", at_line(file, planes[i].line));
    result.stack.slices.push_back(
        slice_of(planes[i], heights[i], frame, limits::off_plane * least, reader.labels(), file, farthest));
    check_contour_count(contours += planes[i].components.size(), at_line(file, planes[i].line));
    for (const Component& component : planes[i].components)
      check_point_count(points += component.vertices.size(), at_line(file, planes[i].line));
  }
  if (farthest > limits::plane_thickness * least) {
    result.remarks.push_back(
        fmt::format("points lie up to {:.3g} off their planes and were projected onto them", farthest));
  }
  return result;
}

}  // namespace odontoscope
