#include "recon/output/write_inp.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "recon/output/shell_groups.h"
#include "recon/output/solid_walls.h"
#include "recon/output/text_values.h"

namespace odontoscope {
namespace {

constexpr std::size_t number_length = 20;   // that CalculiX reads
constexpr std::size_t numbers_in_line = 16; // that solvers read

std::string upper_case(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

/// Faces of C3D4 are numbered S1 = nodes 1 2 3, S2 = 1 4 2, S3 = 2 4 3, S4 = 3 4 1; ours by the vertex opposite.
int solver_face(int face) {
  constexpr int numbers[] = {3, 4, 2, 1};
  return numbers[face];
}

class Writer {
 public:
  explicit Writer(const Reconstruction& reconstruction) : reconstruction_(reconstruction) {}

  std::string text() {
    text_ = "*HEADING\nodontoscope model, millimetres\n";
    text_ += fmt::format("** {}\n", certificate_in_words(WrittenModel(reconstruction_)));
    add_nodes();
    for (const Solid& solid : reconstruction_.solids) {
      add_elements(solid);
      add_ends(solid);
      for (const Wall& wall : walls_of(solid)) add_wall(wall);
      first_node_ += solid.tetrahedra.points.size();
      first_element_ += solid.tetrahedra.tetrahedra.size();
    }
    if (const auto limit = crown_limit(reconstruction_)) add_crown_and_root(*limit);
    return std::move(text_);
  }

 private:
  /// Says in a comment what the set is, and gives its name.
  std::string named(std::string_view meaning, std::string_view wanted) {
    std::string name = upper_case(identifiers_.unique(wanted));
    text_ += fmt::format("** {}: {}\n", name, meaning);
    return name;
  }

  /// In one block, since some readers keep only the last.
  void add_nodes() {
    text_ += "*NODE\n";
    std::size_t number = 1;
    for (const Solid& solid : reconstruction_.solids) {
      for (const Point3& p : solid.tetrahedra.points) {
        fmt::format_to(std::back_inserter(text_), "{}", number++);
        for (const double coordinate : {p.x, p.y, p.z}) {
          text_ += ',';
          append_number(text_, coordinate, number_length);
        }
        text_ += '\n';
      }
    }
  }

  void add_elements(const Solid& solid) {
    const std::string name = named("structure " + solid.structure, solid.structure);
    text_ += fmt::format("*ELEMENT,TYPE=C3D4,ELSET={}\n", name);
    std::size_t number = first_element_;
    for (const auto& [a, b, c, d] : solid.tetrahedra.tetrahedra) {
      fmt::format_to(std::back_inserter(text_), "{},{},{},{},{}\n", number++, first_node_ + a, first_node_ + b,
                     first_node_ + c, first_node_ + d);
    }
  }

  void add_ends(const Solid& solid) {
    const std::vector<Point3>& points = solid.tetrahedra.points;
    if (points.empty()) return;
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [](const Point3& a, const Point3& b) { return a.z < b.z; });
    add_nodes_at("lowest", low->z, solid);
    add_nodes_at("highest", high->z, solid);
  }

  void add_nodes_at(std::string_view which, double z, const Solid& solid) {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < solid.tetrahedra.points.size(); ++i) {
      if (solid.tetrahedra.points[i].z == z) nodes.push_back(first_node_ + i);
    }
    const std::string name = named(fmt::format("nodes of the {} slice of {}", which, solid.structure),
                                   fmt::format("{} {}", solid.structure, which));
    add_set("*NSET,NSET=" + name, nodes);
  }

  void add_wall(const Wall& wall) {
    std::vector<std::size_t> nodes;
    for (const WallFace& face : wall.faces) {
      for (const PointIndex v : face.triangle) nodes.push_back(first_node_ + v);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const std::string name = named("nodes of " + wall.name, wall.name);
    add_set("*NSET,NSET=" + name, nodes);
    const std::string surface = named("faces of " + wall.name, wall.name + " wall");
    text_ += fmt::format("*SURFACE,NAME={},TYPE=ELEMENT\n", surface);
    for (const WallFace& face : wall.faces) {
      fmt::format_to(std::back_inserter(text_), "{},S{}\n", first_element_ + face.tetrahedron, solver_face(face.face));
    }
  }

  void add_crown_and_root(const CrownLimit& limit) {
    std::vector<std::size_t> nodes[2], elements[2];
    std::size_t node = 1, element = 1;
    for (const Solid& solid : reconstruction_.solids) {
      const std::vector<Point3>& points = solid.tetrahedra.points;
      for (const Point3& p : points) nodes[limit.in_crown(p.z)].push_back(node++);
      for (const auto& [a, b, c, d] : solid.tetrahedra.tetrahedra) {
        const double middle = (points[a].z + points[b].z + points[c].z + points[d].z) / 4;
        elements[limit.in_crown(middle)].push_back(element++);
      }
    }
    for (const bool crown : {true, false}) {
      const char* part = crown ? "crown" : "root";
      const std::string where = fmt::format("{} the enamel's edge at z = {:.6g}", crown ? "beyond" : "before", limit.z);
      add_set("*ELSET,ELSET=" + named("elements " + where, part), elements[crown]);
      add_set("*NSET,NSET=" + named("nodes " + where, fmt::format("{} nodes", part)), nodes[crown]);
    }
  }

  void add_set(const std::string& keyword, const std::vector<std::size_t>& members) {
    text_ += keyword;
    for (std::size_t i = 0; i < members.size(); ++i) {
      text_ += i % numbers_in_line == 0 ? "\n" : ",";
      fmt::format_to(std::back_inserter(text_), "{}", members[i]);
    }
    text_ += '\n';
  }

  const Reconstruction& reconstruction_;
  Identifiers identifiers_;
  std::string text_;
  std::size_t first_node_ = 1, first_element_ = 1;
};

}  // namespace

std::string inp_text(const Reconstruction& reconstruction) { return Writer(reconstruction).text(); }

}  // namespace odontoscope
