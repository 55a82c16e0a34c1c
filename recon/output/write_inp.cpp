#include "recon/output/write_inp.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "recon/formats/shell_groups.h"
#include "recon/formats/text_values.h"
#include "recon/output/complex_groups.h"
#include "recon/output/solid_walls.h"

namespace odontoscope {
namespace {

constexpr std::size_t number_length = 20;    // that CalculiX reads
constexpr std::size_t numbers_in_line = 16;  // that solvers read

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
    if (reconstruction_.complex) return complex_text(*reconstruction_.complex);
    add_nodes(reconstruction_.solids);
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
  void add_nodes(const std::vector<Solid>& solids) {
    text_ += "*NODE\n";
    std::size_t number = 1;
    for (const Solid& solid : solids)
      for (const Point3& p : solid.tetrahedra.points) add_node(number++, p);
  }

  void add_node(std::size_t number, const Point3& p) {
    fmt::format_to(std::back_inserter(text_), "{}", number);
    for (const double coordinate : {p.x, p.y, p.z}) {
      text_ += ',';
      append_number(text_, coordinate, number_length);
    }
    text_ += '\n';
  }

  // ---- a partition --------------------------------------------------------------------------------------------------

  std::string complex_text(const LabelledComplex& complex) {
    text_ += "*NODE\n";
    for (std::size_t i = 0; i < complex.mesh.points.size(); ++i) add_node(i + 1, complex.mesh.points[i]);
    for (std::size_t s = 0; s < complex.structures.size(); ++s) add_material(complex, s);
    const std::vector<ElementFace> elements = inner_elements(complex);
    for (const ComplexGroup& group : groups_of(complex)) add_group(complex, group, elements);
    if (const auto limit = crown_limit(reconstruction_)) add_crown_and_root(complex.mesh, *limit);
    return std::move(text_);
  }

  void add_material(const LabelledComplex& complex, std::size_t s) {
    const std::string& structure = complex.structures[s];
    const TetraMesh& mesh = complex.mesh;
    std::vector<std::size_t> nodes;
    std::string elements;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
      if (mesh.labels[t] != s + 1) continue;
      const auto& [a, b, c, d] = mesh.tetrahedra[t];
      fmt::format_to(std::back_inserter(elements), "{},{},{},{},{}\n", t + 1, a + 1, b + 1, c + 1, d + 1);
      nodes.insert(nodes.end(), {a, b, c, d});
    }
    if (nodes.empty()) return;
    text_ += fmt::format("*ELEMENT,TYPE=C3D4,ELSET={}\n", named("structure " + structure, structure)) + elements;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto [low, high] = std::minmax_element(
        nodes.begin(), nodes.end(), [&](std::size_t p, std::size_t q) { return mesh.points[p].z < mesh.points[q].z; });
    const double heights[] = {mesh.points[*low].z, mesh.points[*high].z};
    for (const int end : {0, 1}) {
      const char* which = end == 0 ? "lowest" : "highest";
      std::vector<std::size_t> at;
      for (const std::size_t node : nodes)
        if (mesh.points[node].z == heights[end]) at.push_back(node + 1);
      const std::string name =
          named(fmt::format("nodes of the {} slice of {}", which, structure), fmt::format("{} {}", structure, which));
      add_set("*NSET,NSET=" + name, at);
    }
  }

  void add_group(const LabelledComplex& complex, const ComplexGroup& group, const std::vector<ElementFace>& elements) {
    std::vector<std::size_t> nodes;
    for (const std::uint32_t f : group.faces)
      for (const PointIndex v : complex.interfaces[f].triangle) nodes.push_back(v + std::size_t{1});
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const std::string name = named("nodes of " + group.name, group.name);
    add_set("*NSET,NSET=" + name, nodes);
    const std::string faces =
        named(fmt::format("faces of {}, of elements of {}", group.name, complex.structures[group.inner - 1]),
              group.name + " faces");
    text_ += fmt::format("*SURFACE,NAME={},TYPE=ELEMENT\n", faces);
    for (const std::uint32_t f : group.faces)
      fmt::format_to(std::back_inserter(text_), "{},S{}\n", elements[f].tetrahedron + std::size_t{1},
                     solver_face(elements[f].face));
  }

  void add_crown_and_root(const TetraMesh& mesh, const CrownLimit& limit) {
    std::vector<std::size_t> nodes[2], elements[2];
    for (std::size_t i = 0; i < mesh.points.size(); ++i) nodes[limit.in_crown(mesh.points[i].z)].push_back(i + 1);
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
      double sum = 0;
      for (const PointIndex v : mesh.tetrahedra[t]) sum += mesh.points[v].z;
      elements[limit.in_crown(sum / 4)].push_back(t + 1);
    }
    add_crown_and_root(limit, nodes, elements);
  }

  // ---- solids of their own ------------------------------------------------------------------------------------------

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
    add_crown_and_root(limit, nodes, elements);
  }

  void add_crown_and_root(const CrownLimit& limit, const std::vector<std::size_t> (&nodes)[2],
                          const std::vector<std::size_t> (&elements)[2]) {
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
