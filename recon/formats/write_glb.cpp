#include "recon/formats/write_glb.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <sstream>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/formats/compress_glb.h"
#include "recon/formats/json_values.h"
#include "recon/formats/shell_groups.h"
#include "recon/formats/single_precision.h"
#include "recon/formats/smooth_normals.h"

namespace odontoscope {
namespace {

constexpr double metres_per_millimetre = 1e-3;

constexpr const char* variants_extension = "KHR_materials_variants";
struct Variant {
  const char* name;
  bool see_through, plaster;
};
constexpr std::array<Variant, 3> variant_list{
    {{"natural", false, false}, {"see-through", true, false}, {"plaster", false, true}}};
constexpr Paint plaster{"plaster", {0.80, 0.79, 0.76}, 0.9};

tinygltf::Value gltf_value(const Json& json) {
  if (json.is_object()) {
    tinygltf::Value::Object object;
    for (const auto& [key, value] : json.items()) object[key] = gltf_value(value);
    return tinygltf::Value(std::move(object));
  }
  if (json.is_array()) {
    tinygltf::Value::Array array;
    for (const Json& value : json) array.push_back(gltf_value(value));
    return tinygltf::Value(std::move(array));
  }
  if (json.is_boolean()) return tinygltf::Value(json.get<bool>());
  if (json.is_string()) return tinygltf::Value(json.get<std::string>());
  // tinygltf's whole numbers have 32 bits.
  if (json.is_number_integer() && json.get<double>() <= std::numeric_limits<int>::max() &&
      json.get<double>() >= std::numeric_limits<int>::min()) {
    return tinygltf::Value(json.get<int>());
  }
  if (json.is_number()) return tinygltf::Value(json.get<double>());
  return tinygltf::Value(std::string());
}

/// What proves the surfaces; without times and threads, so that the same input gives the same bytes.
Json certificate(const WrittenModel& model) {
  std::vector<const SurfaceReport*> reports;
  for (const WrittenSurface& solid : model.solids) reports.push_back(&solid.report);
  return {{"certified", is_certified(model)},
          {"slices_checked", model.slices_checked},
          {"surface_in_mm", json_of(reports)}};
}

using FloatQuaternion = std::array<float, 4>;  // x, y, z, w

/// The turn from glTF's camera, which looks along -z with +y up, to this one.
std::array<double, 4> turn_of(const Direction& view_direction, const Direction& up) {
  const Direction right = cross(view_direction, up), back = -1 * view_direction;
  // The matrix with these columns as a quaternion, from its largest component (S. Shepperd, 1978).
  const std::array<double, 4> squares{1 + right.x - up.y - back.z, 1 - right.x + up.y - back.z,
                                      1 - right.x - up.y + back.z, 1 + right.x + up.y + back.z};
  const auto largest = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double yz = up.z + back.y, zx = right.z + back.x, xy = right.y + up.x, x = up.z - back.y, y = back.x - right.z,
               z = right.y - up.x;
  const std::array<std::array<double, 4>, 4> rows{
      {{squares[0], xy, zx, x}, {xy, squares[1], yz, y}, {zx, yz, squares[2], z}, {x, y, z, squares[3]}}};
  std::array<double, 4> turn = rows[largest];
  const double size = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
  for (double& component : turn) component /= size;
  return turn;
}

/// A turn a key; of the two quaternions that mean it the one nearer to that before, since players go the short way only
/// then.
std::vector<FloatQuaternion> turns_of(const std::vector<CameraKey>& keys) {
  std::vector<FloatQuaternion> turns;
  std::array<double, 4> before{0, 0, 0, 1};
  for (const CameraKey& key : keys) {
    std::array<double, 4> turn = turn_of(key.view_direction, key.up);
    double along = 0;
    for (std::size_t i = 0; i < 4; ++i) along += turn[i] * before[i];
    for (double& component : turn) component *= along < 0 ? -1 : 1;
    turns.push_back({static_cast<float>(turn[0]), static_cast<float>(turn[1]), static_cast<float>(turn[2]),
                     static_cast<float>(turn[3])});
    before = turn;
  }
  return turns;
}

/// Builds the model piece by piece: one buffer, one view an accessor.
class Builder {
 public:
  explicit Builder(const WrittenModel& model) {
    model_.asset.version = "2.0";
    model_.asset.generator = "odontoscope";
    model_.asset.extras = gltf_value(certificate(model));
    model_.buffers.emplace_back();
    tinygltf::Node root;
    root.name = "z up";
    root.matrix = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};  // by columns: (x, y, z) to (x, z, -y)
    model_.nodes.push_back(std::move(root));
    model_.scenes.emplace_back();
    model_.scenes.front().nodes = {0};
    model_.defaultScene = 0;
  }

  void add_solid(const WrittenSurface& solid, const std::vector<FloatPoint>& points, const GlbOptions& options) {
    see_through_ = options.see_through;
    variants_ = options.variants;
    const std::vector<ShellGroup> groups = shell_groups(solid);
    const ShadedVertices shaded = smooth_normals(solid.surface, options.crease_angle_deg);
    for (const ShellGroup& group : groups) add_group(group, points, shaded);
  }

  void add_hotspot(const GlbHotspot& hotspot) {
    tinygltf::Node node;
    node.name = hotspot.name;
    node.translation = {metres_per_millimetre * hotspot.at.x, metres_per_millimetre * hotspot.at.y,
                        metres_per_millimetre * hotspot.at.z};
    node.extras = gltf_value({{"hotspot", true}});
    model_.nodes.front().children.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(std::move(node));
  }

  void name_variants() {
    Json names = Json::array();
    for (const Variant& variant : variant_list) names.push_back({{"name", variant.name}});
    model_.extensions[variants_extension] = gltf_value({{"variants", names}});
    model_.extensionsUsed.emplace_back(variants_extension);
  }

  void add_path(const CameraPath& path) {
    std::vector<float> times;
    std::vector<FloatPoint> places;
    for (const CameraKey& key : path.keys) {
      times.push_back(static_cast<float>(key.seconds));
      places.push_back({static_cast<float>(metres_per_millimetre * key.at.x),
                        static_cast<float>(metres_per_millimetre * key.at.y),
                        static_cast<float>(metres_per_millimetre * key.at.z)});
    }
    const std::vector<FloatQuaternion> turns = turns_of(path.keys);
    const int node = add_camera(path, places.front(), turns.front());

    tinygltf::Animation animation;
    animation.name = path.name;
    const int input = add_accessor(times.data(), sizeof(float) * times.size(), times.size(),
                                   {0, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR});
    model_.accessors.back().minValues = {times.front()};
    model_.accessors.back().maxValues = {times.back()};
    const int translation = add_accessor(places.data(), sizeof(FloatPoint) * places.size(), places.size(),
                                         {0, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3});
    const int rotation = add_accessor(turns.data(), sizeof(FloatQuaternion) * turns.size(), turns.size(),
                                      {0, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4});
    for (const auto& [output, moved] : {std::pair(translation, "translation"), std::pair(rotation, "rotation")}) {
      tinygltf::AnimationSampler sampler;
      sampler.input = input;
      sampler.output = output;
      sampler.interpolation = "LINEAR";
      tinygltf::AnimationChannel channel;
      channel.sampler = static_cast<int>(animation.samplers.size());
      channel.target_node = node;
      channel.target_path = moved;
      animation.samplers.push_back(std::move(sampler));
      animation.channels.push_back(std::move(channel));
    }
    model_.animations.push_back(std::move(animation));
  }

  /// GLB, or glTF's text with the buffer embedded.
  std::string bytes(bool binary) {
    if (model_.meshes.empty()) {  // an empty list or buffer is not allowed
      model_.buffers.clear();
    }
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model_, stream, !binary, binary)) throw InternalError("tinygltf wrote no glTF");
    return std::move(stream).str();
  }

 private:
  void add_group(const ShellGroup& group, const std::vector<FloatPoint>& points, const ShadedVertices& shaded) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(shaded.point.size(), unused), indices;
    std::vector<FloatPoint> positions, normals;
    for (const std::uint32_t t : group.triangles) {
      for (const PointIndex v : shaded.triangles[t]) {
        if (number[v] == unused) {
          number[v] = static_cast<std::uint32_t>(positions.size());
          positions.push_back(points[shaded.point[v]]);
          const Direction& n = shaded.normals[v];
          normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
        }
        indices.push_back(number[v]);
      }
    }
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = add_vectors(positions);
    primitive.attributes["NORMAL"] = add_vectors(normals);
    primitive.indices = add_indices(indices);
    const Paint& paint = paint_for(group.structure, group.kind);
    primitive.material = material(paint, see_through_);
    if (variants_) primitive.extensions[variants_extension] = gltf_value({{"mappings", mappings_of(paint)}});
    bound(model_.accessors[static_cast<std::size_t>(primitive.attributes["POSITION"])], positions);

    tinygltf::Mesh mesh;
    mesh.name = group.name;
    mesh.primitives.push_back(std::move(primitive));
    tinygltf::Node node;
    node.name = group.name;
    node.mesh = static_cast<int>(model_.meshes.size());
    node.extras = gltf_value({{"structure", group.structure},
                              {"kind", name(group.kind)},
                              {"shells", group.shells},
                              {"volume_mm3", group.volume}});
    model_.meshes.push_back(std::move(mesh));
    model_.nodes.front().children.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(std::move(node));
  }

  /// The node's number. It stands where the path begins.
  int add_camera(const CameraPath& path, const FloatPoint& place, const FloatQuaternion& turn) {
    tinygltf::Camera camera;
    camera.name = path.name;
    camera.type = "perspective";
    camera.perspective.yfov = path.field_of_view_deg * std::numbers::pi / 180;
    camera.perspective.znear = metres_per_millimetre * path.near_mm;
    camera.perspective.zfar = metres_per_millimetre * path.far_mm;
    tinygltf::Node node;
    node.name = path.name;
    node.camera = static_cast<int>(model_.cameras.size());
    node.translation.assign(place.begin(), place.end());
    node.rotation.assign(turn.begin(), turn.end());
    const int number = static_cast<int>(model_.nodes.size());
    model_.cameras.push_back(std::move(camera));
    model_.nodes.front().children.push_back(number);
    model_.nodes.push_back(std::move(node));
    return number;
  }

  static void bound(tinygltf::Accessor& accessor, const std::vector<FloatPoint>& positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(positions.begin(), positions.end(),
                                                   [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      accessor.minValues.push_back((*low)[axis]);
      accessor.maxValues.push_back((*high)[axis]);
    }
  }

  int add_vectors(const std::vector<FloatPoint>& vectors) {
    return add_accessor(vectors.data(), sizeof(FloatPoint) * vectors.size(), vectors.size(),
                        {TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3});
  }
  int add_indices(const std::vector<std::uint32_t>& indices) {
    return add_accessor(
        indices.data(), sizeof(std::uint32_t) * indices.size(), indices.size(),
        {TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR});
  }

  struct Layout {
    int target, component, type;
  };
  /// All components have four bytes, so that every view starts aligned.
  int add_accessor(const void* data, std::size_t bytes, std::size_t count, const Layout& layout) {
    std::vector<unsigned char>& buffer = model_.buffers.front().data;
    if (buffer.size() + bytes > limits::glb_bytes) {
      throw UsageError("the model is too large for GLB", "Simplify it with --triangles, or write .ply");
    }
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = layout.target;
    const auto* first = static_cast<const unsigned char*>(data);
    buffer.insert(buffer.end(), first, first + bytes);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    accessor.componentType = layout.component;
    accessor.type = layout.type;
    accessor.count = count;
    model_.bufferViews.push_back(std::move(view));
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  /// Which material a surface of this paint has in which variant.
  Json mappings_of(const Paint& paint) {
    Json mappings = Json::array();
    for (std::size_t i = 0; i < variant_list.size(); ++i)
      mappings.push_back(
          {{"material", material(variant_list[i].plaster ? plaster : paint, variant_list[i].see_through)},
           {"variants", Json::array({i})}});
    return mappings;
  }

  int material(const Paint& paint, bool see_through) {
    const bool clear = see_through && paint.see_through < 1;
    // Of both kinds only where there are variants; without, a name says it all.
    const std::string called = std::string(paint.name) + (clear && variants_ ? ", clear" : "");
    const auto known = std::find_if(model_.materials.begin(), model_.materials.end(),
                                    [&](const tinygltf::Material& m) { return m.name == called; });
    if (known != model_.materials.end()) return static_cast<int>(known - model_.materials.begin());
    tinygltf::Material fresh;
    fresh.name = called;
    fresh.doubleSided = false;
    fresh.pbrMetallicRoughness.baseColorFactor = {paint.colour[0], paint.colour[1], paint.colour[2],
                                                  clear ? paint.see_through : 1};
    if (clear) fresh.alphaMode = "BLEND";
    fresh.pbrMetallicRoughness.metallicFactor = 0;
    fresh.pbrMetallicRoughness.roughnessFactor = paint.roughness;
    model_.materials.push_back(std::move(fresh));
    return static_cast<int>(model_.materials.size()) - 1;
  }

  tinygltf::Model model_;
  bool see_through_ = false, variants_ = false;
};

std::string bytes_of(const WrittenModel& model, const GlbOptions& options, bool binary) {
  Builder builder(model);
  const std::vector<std::vector<FloatPoint>> points = distinct_floats(model, metres_per_millimetre);
  for (std::size_t s = 0; s < model.solids.size(); ++s) builder.add_solid(model.solids[s], points[s], options);
  for (const CameraPath& path : options.paths) builder.add_path(path);
  for (const GlbHotspot& hotspot : options.hotspots) builder.add_hotspot(hotspot);
  if (options.variants && !model.solids.empty()) builder.name_variants();
  if (!options.compressed) return builder.bytes(binary);
  const std::string plain = builder.bytes(true);
  return binary ? compressed_glb(plain) : compressed_gltf(plain);
}

}  // namespace

std::string glb_bytes(const WrittenModel& model, const GlbOptions& options) { return bytes_of(model, options, true); }

std::string gltf_text(const WrittenModel& model, const GlbOptions& options) { return bytes_of(model, options, false); }

}  // namespace odontoscope
