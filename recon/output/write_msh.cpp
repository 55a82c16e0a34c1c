#include "recon/output/write_msh.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

#include "recon/formats/shell_groups.h"
#include "recon/formats/text_values.h"
#include "recon/output/complex_groups.h"
#include "recon/output/solid_walls.h"

namespace odontoscope {
namespace {

constexpr int surface = 2, volume = 3;          // dimensions
constexpr int three_nodes = 2, four_nodes = 4;  // element types: triangle, tetrahedron

/// What the sections of the file say of one structure. Tags count from 1, surfaces through all structures.
struct Part {
  const Solid& solid;
  std::vector<Wall> walls;
  std::size_t volume_tag = 0, first_surface_tag = 0, first_node = 0;
};

std::vector<Part> parts_of(const Reconstruction& reconstruction) {
  std::vector<Part> parts;
  std::size_t surfaces = 0, nodes = 0;
  for (const Solid& solid : reconstruction.solids) {
    parts.push_back({solid, walls_of(solid), parts.size() + 1, surfaces + 1, nodes + 1});
    surfaces += parts.back().walls.size();
    nodes += solid.tetrahedra.points.size();
  }
  return parts;
}

/// The format knows no escapes.
std::string quoted(std::string name) {
  std::replace(name.begin(), name.end(), '"', '\'');
  return '"' + name + '"';
}

std::string names(const std::vector<Part>& parts) {
  std::string list;
  std::size_t groups = 0;
  for (const Part& part : parts) {
    for (std::size_t w = 0; w < part.walls.size(); ++w, ++groups) {
      list += fmt::format("{} {} {}\n", surface, part.first_surface_tag + w, quoted(part.walls[w].name));
    }
  }
  for (const Part& part : parts) {
    list += fmt::format("{} {} {}\n", volume, part.volume_tag, quoted(part.solid.structure));
  }
  return fmt::format("$PhysicalNames\n{}\n{}$EndPhysicalNames\n", groups + parts.size(), list);
}

/// "low x y z, high x y z" of some points.
template <class Points>
std::string box_of(const Points& points) {
  double low[3], high[3];
  std::fill_n(low, 3, std::numeric_limits<double>::max());
  std::fill_n(high, 3, std::numeric_limits<double>::lowest());
  for (const Point3& p : points) {
    const double coordinates[3] = {p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], coordinates[axis]);
      high[axis] = std::max(high[axis], coordinates[axis]);
    }
  }
  std::string text;
  for (const double value : {low[0], low[1], low[2], high[0], high[1], high[2]}) {
    append_number(text, value);
    text += ' ';
  }
  return text;
}

std::vector<Point3> corners_of(const Wall& wall, const TetraMesh& mesh) {
  std::vector<Point3> corners;
  for (const WallFace& face : wall.faces) {
    for (const PointIndex v : face.triangle) corners.push_back(mesh.points[v]);
  }
  return corners;
}

/// Each entity with its box, its physical group (of its own number), and the surfaces that bound it.
std::string entities(const std::vector<Part>& parts) {
  std::string surfaces, volumes;
  std::size_t surface_count = 0;
  for (const Part& part : parts) {
    std::string bounds;
    for (std::size_t w = 0; w < part.walls.size(); ++w, ++surface_count) {
      const std::size_t tag = part.first_surface_tag + w;
      surfaces += fmt::format("{} {}1 {} 0\n", tag, box_of(corners_of(part.walls[w], part.solid.tetrahedra)), tag);
      bounds += fmt::format(" {}", tag);
    }
    volumes += fmt::format("{0} {1}1 {0} {2}{3}\n", part.volume_tag, box_of(part.solid.tetrahedra.points),
                           part.walls.size(), bounds);
  }
  return fmt::format("$Entities\n0 0 {} {}\n{}{}$EndEntities\n", surface_count, parts.size(), surfaces, volumes);
}

/// A block's node numbers from `first` on, then their places.
void append_nodes(std::string& text, std::size_t first, const std::vector<Point3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) fmt::format_to(std::back_inserter(text), "{}\n", first + i);
  for (const Point3& p : points) {
    append_point(text, p);
    text += '\n';
  }
}

std::string nodes(const std::vector<Part>& parts) {
  std::size_t count = 0;
  for (const Part& part : parts) count += part.solid.tetrahedra.points.size();
  std::string text = fmt::format("$Nodes\n{} {} {} {}\n", parts.size(), count, count == 0 ? 0 : 1, count);
  for (const Part& part : parts) {
    const std::vector<Point3>& points = part.solid.tetrahedra.points;
    text += fmt::format("{} {} 0 {}\n", volume, part.volume_tag, points.size());
    append_nodes(text, part.first_node, points);
  }
  return text + "$EndNodes\n";
}

std::string elements_of(const std::vector<Part>& parts) {
  std::size_t blocks = 0, count = 0;
  std::string text;
  const auto add = [&](std::size_t first_node, const auto& corners) {
    fmt::format_to(std::back_inserter(text), "{}", ++count);
    for (const PointIndex v : corners) fmt::format_to(std::back_inserter(text), " {}", first_node + v);
    text += '\n';
  };
  for (const Part& part : parts) {
    for (std::size_t w = 0; w < part.walls.size(); ++w, ++blocks) {
      const std::vector<WallFace>& faces = part.walls[w].faces;
      text += fmt::format("{} {} {} {}\n", surface, part.first_surface_tag + w, three_nodes, faces.size());
      for (const WallFace& face : faces) add(part.first_node, face.triangle);
    }
    const std::vector<Tetrahedron>& tetrahedra = part.solid.tetrahedra.tetrahedra;
    text += fmt::format("{} {} {} {}\n", volume, part.volume_tag, four_nodes, tetrahedra.size());
    for (const Tetrahedron& tetrahedron : tetrahedra) add(part.first_node, tetrahedron);
    ++blocks;
  }
  return fmt::format("$Elements\n{} {} {} {}\n", blocks, count, count == 0 ? 0 : 1, count) + text + "$EndElements\n";
}

// ---- a partition ----------------------------------------------------------------------------------------------------

/// Volumes have the labels as tags, surfaces the numbers of their groups from 1.
class ComplexWriter {
 public:
  explicit ComplexWriter(const LabelledComplex& complex)
      : complex_(complex), groups_(groups_of(complex)), of_label_(complex.structures.size()) {
    for (std::uint32_t t = 0; t < complex.mesh.tetrahedra.size(); ++t)
      of_label_[complex.mesh.labels[t] - 1].push_back(t);
  }

  std::string text() const { return names() + entities() + nodes() + elements(); }

 private:
  std::size_t volumes() const { return complex_.structures.size(); }

  std::string names() const {
    std::string list;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      list += fmt::format("{} {} {}\n", surface, g + 1, quoted(groups_[g].name));
    for (std::size_t s = 0; s < volumes(); ++s)
      list += fmt::format("{} {} {}\n", volume, s + 1, quoted(complex_.structures[s]));
    return fmt::format("$PhysicalNames\n{}\n{}$EndPhysicalNames\n", groups_.size() + volumes(), list);
  }

  template <class Cells>
  std::string box_of_cells(const Cells& cells) const {
    std::vector<Point3> corners;
    for (const auto& cell : cells)
      for (const PointIndex v : cell) corners.push_back(complex_.mesh.points[v]);
    return box_of(corners);
  }

  std::string entities() const {
    std::string surfaces, solids;
    std::vector<std::string> bounds(volumes());
    std::vector<std::size_t> count(volumes(), 0);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      std::vector<Triangle> faces;
      for (const std::uint32_t f : groups_[g].faces) faces.push_back(complex_.interfaces[f].triangle);
      surfaces += fmt::format("{} {}1 {} 0\n", g + 1, box_of_cells(faces), g + 1);
      bounds[groups_[g].inner - 1] += fmt::format(" {}", g + 1);
      ++count[groups_[g].inner - 1];
      if (groups_[g].outer == void_label) continue;
      bounds[groups_[g].outer - 1] += fmt::format(" -{}", g + 1);
      ++count[groups_[g].outer - 1];
    }
    for (std::size_t s = 0; s < volumes(); ++s) {
      std::vector<Tetrahedron> own;
      for (const std::uint32_t t : of_label_[s]) own.push_back(complex_.mesh.tetrahedra[t]);
      if (own.empty())
        own.push_back({0, 0, 0, 0});  // nothing is left of the structure: a box is asked for all the same
      solids += fmt::format("{0} {1}1 {0} {2}{3}\n", s + 1, box_of_cells(own), count[s], bounds[s]);
    }
    return fmt::format("$Entities\n0 0 {} {}\n{}{}$EndEntities\n", groups_.size(), volumes(), surfaces, solids);
  }

  /// All in one block, under the first volume: a node belongs to several.
  std::string nodes() const {
    const std::vector<Point3>& points = complex_.mesh.points;
    std::string text =
        fmt::format("$Nodes\n1 {0} {1} {0}\n{2} 1 0 {0}\n", points.size(), points.empty() ? 0 : 1, volume);
    append_nodes(text, 1, points);
    return text + "$EndNodes\n";
  }

  std::string elements() const {
    std::size_t blocks = 0, count = 0;
    std::string text;
    const auto add = [&](const auto& corners) {
      fmt::format_to(std::back_inserter(text), "{}", ++count);
      for (const PointIndex v : corners) fmt::format_to(std::back_inserter(text), " {}", v + std::size_t{1});
      text += '\n';
    };
    for (std::size_t g = 0; g < groups_.size(); ++g, ++blocks) {
      text += fmt::format("{} {} {} {}\n", surface, g + 1, three_nodes, groups_[g].faces.size());
      for (const std::uint32_t f : groups_[g].faces) add(complex_.interfaces[f].triangle);
    }
    for (std::size_t s = 0; s < volumes(); ++s) {
      if (of_label_[s].empty()) continue;
      ++blocks;
      text += fmt::format("{} {} {} {}\n", volume, s + 1, four_nodes, of_label_[s].size());
      for (const std::uint32_t t : of_label_[s]) add(complex_.mesh.tetrahedra[t]);
    }
    return fmt::format("$Elements\n{} {} {} {}\n", blocks, count, count == 0 ? 0 : 1, count) + text + "$EndElements\n";
  }

  const LabelledComplex& complex_;
  std::vector<ComplexGroup> groups_;
  std::vector<std::vector<std::uint32_t>> of_label_;  // tetrahedra
};

}  // namespace

std::string msh_text(const Reconstruction& reconstruction) {
  if (reconstruction.complex) {
    return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" +
           fmt::format("$Comments\nmade by odontoscope; millimetres; one conforming complex; {}\n$EndComments\n",
                       certificate_in_words(WrittenModel(reconstruction))) +
           ComplexWriter(*reconstruction.complex).text();
  }
  const std::vector<Part> parts = parts_of(reconstruction);
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" +
         fmt::format("$Comments\nmade by odontoscope; millimetres; {}\n$EndComments\n",
                     certificate_in_words(WrittenModel(reconstruction))) +
         names(parts) + entities(parts) + nodes(parts) + elements_of(parts);
}

}  // namespace odontoscope
