#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "recon/core/free_memory.h"
#include "recon/core/limits.h"
#include "recon/formats/gltf_accessors.h"
#include "recon/formats/parsing.h"
#include "recon/formats/read_mesh.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {
namespace {

using gltf::Glb;
using nlohmann::json;

constexpr double millimetres_per_metre = 1000;

/// Affine map: columns x, y, z and the shift.
struct Transform {
  double m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  Point3 operator()(const std::array<float, 3>& p) const {
    double r[3];
    for (int i = 0; i < 3; ++i) r[i] = m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3];
    return {r[0], r[1], r[2]};
  }
  bool mirrors() const {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
           0;
  }
};

Transform operator*(const Transform& a, const Transform& b) {
  Transform product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      product.m[i][j] = j == 3 ? a.m[i][3] : 0;
      for (int k = 0; k < 3; ++k) product.m[i][j] += a.m[i][k] * b.m[k][j];
    }
  }
  return product;
}

/// node[key] as exactly `count` finite numbers; empty where it is missing.
std::vector<double> numbers(const Glb& glb, const json& node, const char* key, std::size_t count) {
  std::vector<double> values;
  const auto found = node.find(key);
  if (found == node.end()) return values;
  if (!found->is_array() || found->size() != count)
    glb.refuse("unparsable", fmt::format("\"{}\" has not {} numbers", key, count));
  for (const json& value : *found) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      glb.refuse("unparsable", fmt::format("\"{}\" holds something else than a number", key));
    values.push_back(value.get<double>());
  }
  return values;
}

Transform local_transform(const Glb& glb, const json& node) {
  Transform t;
  const std::vector<double> matrix = numbers(glb, node, "matrix", 16);
  if (!matrix.empty()) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) t.m[i][j] = matrix[4 * j + i];
    }
    return t;
  }
  const std::vector<double> scale = numbers(glb, node, "scale", 3), rotation = numbers(glb, node, "rotation", 4),
                            translation = numbers(glb, node, "translation", 3);
  if (!rotation.empty()) {
    const double x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
    t = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0},
          {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0},
          {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0}}};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3 && !scale.empty(); ++j) t.m[i][j] *= scale[j];
    if (!translation.empty()) t.m[i][3] = translation[i];
  }
  return t;
}

constexpr std::uint64_t triangle_list = 4, triangle_strip = 5, triangle_fan = 6;

/// Corners of a strip or a fan as those of triangles, each as the standard turns it; triangles that name a corner twice
/// only lead on.
std::vector<std::uint32_t> as_list(std::uint64_t mode, const std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> listed;
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    Triangle t{corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]};
    if (mode == triangle_fan) t = {corners[i + 1], corners[i + 2], corners[0]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) listed.insert(listed.end(), t.begin(), t.end());
  }
  return listed;
}

void add_triangles(const Glb& glb, const std::vector<std::uint32_t>& corners, std::size_t vertices, bool mirrored,
                   SurfaceMesh& surface) {
  if (corners.size() % 3 != 0)
    glb.refuse("not-triangles", fmt::format("{} corners make no whole triangles", corners.size()));
  const auto first = static_cast<PointIndex>(surface.points.size());
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[i + k] >= vertices) {
        glb.refuse("index-out-of-range", fmt::format("a triangle names vertex {} of {}", corners[i + k], vertices));
      }
      t[k] = first + corners[i + k];
    }
    if (mirrored) std::swap(t[1], t[2]);
    surface.triangles.push_back(t);
  }
}

/// Walks the nodes of the scene and collects their meshes.
class SceneReader {
 public:
  explicit SceneReader(const Glb& glb) : glb_(glb), visited_(gltf::list(glb, "nodes").size(), false) {}

  std::vector<NamedMesh> read() {
    // glTF has +y up; this turns it so that +z is.
    Transform to_ours;
    for (auto& row : to_ours.m) row[0] = row[1] = row[2] = 0;
    to_ours.m[0][0] = to_ours.m[2][1] = millimetres_per_metre;
    to_ours.m[1][2] = -millimetres_per_metre;

    check_size();
    walk(to_ours, [this](const json& node, const Transform& world) { add_mesh(node, world); });
    tell();
    return std::move(meshes_);
  }

 private:
  /// Calls for each node that draws a mesh, in the order of the tree.
  template <class Call>
  void walk(const Transform& to_ours, const Call& call) {
    std::fill(visited_.begin(), visited_.end(), false);
    std::vector<std::pair<std::size_t, Transform>> waiting;
    const std::vector<std::size_t> roots = root_nodes();
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) waiting.emplace_back(*root, to_ours);
    while (!waiting.empty()) {
      const auto [index, parent] = waiting.back();
      waiting.pop_back();
      if (visited_[index])
        glb_.refuse("bad-node-tree", fmt::format("node {} has two parents, or is its own ancestor", index));
      visited_[index] = true;
      const json& node = gltf::entry(glb_, "nodes", index);
      const Transform world = parent * local_transform(glb_, node);
      if (node.contains("mesh")) call(node, world);
      const std::vector<std::size_t> children = node_list(node, "children");
      for (auto child = children.rbegin(); child != children.rend(); ++child) waiting.emplace_back(*child, world);
    }
  }

  /// A small file can draw one mesh from many nodes: what it would take, by what it says, before it is taken.
  void check_size() {
    std::map<std::size_t, std::size_t> drawn;
    walk({}, [&](const json& node, const Transform&) { ++drawn[gltf::index_into(glb_, node, "mesh", "meshes")]; });
    double triangles = 0, vertices = 0, meshes = 0;
    for (const auto& [mesh, times] : drawn) {
      meshes += static_cast<double>(times);
      const json& object = gltf::entry(glb_, "meshes", mesh);
      const auto primitives = object.find("primitives");
      if (primitives == object.end() || !primitives->is_array()) continue;  // refused when it is read
      for (const json& primitive : *primitives) {
        const double points = count_of(
            primitive.is_object() && primitive.contains("attributes") ? primitive["attributes"] : json(), "POSITION");
        const double corners =
            primitive.is_object() && primitive.contains("indices") ? count_of(primitive, "indices") : points;
        vertices += static_cast<double>(times) * points;
        triangles += static_cast<double>(times) * corners / 3;
      }
    }
    if (triangles > static_cast<double>(limits::triangles) || vertices > 3.0 * static_cast<double>(limits::triangles)) {
      glb_.refuse("too-large", fmt::format("the scene has more than {} triangles", limits::triangles));
    }
    // As read and as joined, and a name, lists and remarks for each mesh.
    constexpr double bytes_of_mesh = 512;
    check_memory(glb_.file, 2 * (triangles * sizeof(Triangle) + vertices * sizeof(Point3)) + meshes * bytes_of_mesh,
                 "Export it with fewer copies of its meshes, or use a larger machine");
  }

  /// Of the accessor that `object[key]` names, as it says; 0 where it says nothing of use, which is refused when it is
  /// read.
  double count_of(const json& object, const char* key) const {
    if (!object.is_object()) return 0;
    const auto index = object.find(key);
    const json& accessors = gltf::list(glb_, "accessors");
    if (index == object.end() || !index->is_number_unsigned() || index->get<std::size_t>() >= accessors.size())
      return 0;
    const json& accessor = accessors[index->get<std::size_t>()];
    const auto count = accessor.is_object() ? accessor.find("count") : accessor.end();
    if (!accessor.is_object() || count == accessor.end() || !count->is_number_unsigned()) return 0;
    return count->get<double>() <= bytes_of_view(accessor) ? count->get<double>() : 0;
  }

  /// Of the view that it reads from, as that says; without bound where it names none of use. More elements than bytes
  /// are a lie.
  double bytes_of_view(const json& accessor) const {
    const auto view = accessor.find("bufferView");
    const json& views = gltf::list(glb_, "bufferViews");
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    if (view == accessor.end() || !view->is_number_unsigned() || view->get<std::size_t>() >= views.size())
      return unbounded;
    const json& object = views[view->get<std::size_t>()];
    const auto bytes = object.is_object() ? object.find("byteLength") : object.end();
    return object.is_object() && bytes != object.end() && bytes->is_number_unsigned() ? bytes->get<double>()
                                                                                      : unbounded;
  }

  void tell() {
    if (meshes_.empty()) return;
    std::vector<std::string>& remarks = meshes_.front().remarks;
    remarks = glb_.remarks;
    if (mislabelled_ > 0) {
      remarks.push_back(
          fmt::format("{} called a strip or fan of triangles, but closed only as a list: read as a list",
                      mislabelled_ == 1 ? "1 primitive is" : fmt::format("{} primitives are", mislabelled_)));
    }
    if (points_and_lines_ > 0)
      remarks.push_back(
          fmt::format("{} of points or lines left out",
                      points_and_lines_ == 1 ? "1 primitive" : fmt::format("{} primitives", points_and_lines_)));
  }

  std::vector<std::size_t> node_list(const json& object, const char* key) {
    std::vector<std::size_t> nodes;
    const auto found = object.find(key);
    if (found == object.end()) return nodes;
    if (!found->is_array()) glb_.refuse("unparsable", fmt::format("\"{}\" is no list", key));
    for (const json& value : *found) nodes.push_back(gltf::index_into(glb_, value, "nodes"));
    return nodes;
  }

  /// Of the file's scene, or, if it has none, all nodes that are nobody's child.
  std::vector<std::size_t> root_nodes() {
    if (!gltf::list(glb_, "scenes").empty()) {
      return node_list(gltf::entry(glb_, "scenes", gltf::whole(glb_, glb_.document, "scene", 0)), "nodes");
    }
    std::vector<char> child(visited_.size(), 0);
    for (std::size_t i = 0; i < child.size(); ++i) {
      for (const std::size_t c : node_list(gltf::entry(glb_, "nodes", i), "children")) child[c] = 1;
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < child.size(); ++i) {
      if (!child[i]) roots.push_back(i);
    }
    return roots;
  }

  std::string name_of(const json& node, const json& mesh) const {
    for (const json* object : {&node, &mesh}) {
      const auto name = object->find("name");
      if (name != object->end() && name->is_string()) return parsing::tame(name->get<std::string>());
    }
    return {};
  }

  void add_mesh(const json& node, const Transform& world) {
    if (node.contains("skin"))
      glb_.refuse("unsupported", "a mesh has a skin", "Export it in its rest pose, without a skeleton");
    const json& mesh = gltf::entry(glb_, "meshes", gltf::index_into(glb_, node, "mesh", "meshes"));
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      glb_.refuse("unparsable", "a mesh has no list of primitives");
    SurfaceMesh surface;
    for (const json& primitive : *primitives) add_primitive(primitive, world, surface);
    if (surface.triangles.empty()) return;
    meshes_.push_back({name_of(node, mesh), weld(surface)});
  }

  void add_primitive(const json& primitive, const Transform& world, SurfaceMesh& surface) {
    if (!primitive.is_object()) glb_.refuse("unparsable", "a primitive is no object");
    const std::uint64_t mode = gltf::whole(glb_, primitive, "mode", triangle_list);
    if (mode > triangle_fan) glb_.refuse("unparsable", fmt::format("a primitive has mode {}", mode));
    if (mode < triangle_list) {
      ++points_and_lines_;
      return;
    }
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object())
      glb_.refuse("unparsable", "a primitive has no attributes");
    const auto positions = gltf::read_positions(glb_, gltf::index_into(glb_, *attributes, "POSITION", "accessors"));
    std::vector<std::uint32_t> corners;
    if (primitive.contains("indices")) {
      corners = gltf::read_indices(glb_, gltf::index_into(glb_, primitive, "indices", "accessors"));
    } else {
      corners.resize(positions.size());
      for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
    }
    // A small file can draw one mesh from many nodes.
    vertices_ += positions.size();
    triangles_ += mode == triangle_list ? corners.size() / 3 : corners.size();
    if (triangles_ > limits::triangles || vertices_ > 3 * limits::triangles) {
      glb_.refuse("too-large", fmt::format("the scene has more than {} triangles", limits::triangles));
    }
    if (mode != triangle_list) corners = listed(mode, positions, corners);
    add_triangles(glb_, corners, positions.size(), world.mirrors(), surface);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Point3 point = world(positions[i]);
      const std::string_view fault = parsing::coordinate_fault(point);
      if (!fault.empty()) glb_.refuse(fault, fmt::format("vertex {} has no usable coordinates", i));
      surface.points.push_back(point);
    }
  }

  /// A list that is only called a strip or a fan makes no surface as such, but a sound one as what it is; that is told.
  std::vector<std::uint32_t> listed(std::uint64_t mode, const std::vector<std::array<float, 3>>& positions,
                                    const std::vector<std::uint32_t>& corners) {
    const auto is_sound = [&](const std::vector<std::uint32_t>& of_triangles) {
      SurfaceMesh surface;
      add_triangles(glb_, of_triangles, positions.size(), false, surface);
      for (const auto& p : positions) {
        surface.points.push_back({p[0], p[1], p[2]});
        if (!parsing::coordinate_fault(surface.points.back()).empty()) return false;
      }
      return inspect(weld(surface)).closed_oriented_manifold();
    };
    std::vector<std::uint32_t> as_said = as_list(mode, corners);
    if (corners.size() % 3 != 0 || is_sound(as_said) || !is_sound(corners)) return as_said;
    ++mislabelled_;
    return corners;
  }

  const Glb& glb_;
  std::vector<char> visited_;
  std::vector<NamedMesh> meshes_;
  std::size_t triangles_ = 0, vertices_ = 0, points_and_lines_ = 0, mislabelled_ = 0;
};

}  // namespace

namespace {

std::vector<NamedMesh> meshes_of(const Glb& glb) {
  std::vector<NamedMesh> meshes = SceneReader(glb).read();
  if (meshes.empty()) glb.refuse("empty-mesh", "the file holds no triangle");
  return meshes;
}

}  // namespace

std::vector<NamedMesh> parse_glb(std::string_view bytes, const std::string& file) {
  return meshes_of(gltf::parse_container(bytes, file));
}
std::vector<NamedMesh> parse_gltf(std::string_view bytes, const std::string& file) {
  return meshes_of(gltf::parse_document(bytes, file));
}

}  // namespace odontoscope
