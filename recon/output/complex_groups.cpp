#include "recon/output/complex_groups.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "recon/core/error.h"
#include "recon/delaunay/face_table.h"

namespace odontoscope {
namespace {

/// The field has names for the two that every tooth has.
std::string name_of(const LabelledComplex& complex, Label inner, Label outer) {
  const std::string& one = complex.structures.at(inner - 1);
  if (outer == void_label) return one + " outside";
  const std::string& other = complex.structures.at(outer - 1);
  const auto are = [&](const char* a, const char* b) { return (one == a && other == b) || (one == b && other == a); };
  if (are("enamel", "dentine")) return "enamel-dentine junction";
  if (are("pulp", "dentine")) return "pulp wall";
  return fmt::format("{}-{} border", one, other);
}

}  // namespace

std::vector<ComplexGroup> groups_of(const LabelledComplex& complex) {
  std::map<std::pair<Label, Label>, std::vector<std::uint32_t>> faces;
  for (std::uint32_t f = 0; f < complex.interfaces.size(); ++f)
    faces[{complex.interfaces[f].inner, complex.interfaces[f].outer}].push_back(f);
  std::vector<ComplexGroup> groups;
  for (auto& [labels, list] : faces)
    groups.push_back({name_of(complex, labels.first, labels.second), labels.first, labels.second, std::move(list)});
  return groups;
}

std::vector<ElementFace> inner_elements(const LabelledComplex& complex) {
  using delaunay::FaceTable;
  const auto& tetrahedra = complex.mesh.tetrahedra;
  FaceTable table(tetrahedra.size() * 4);  // room for the faces within a material, which are asked for below
  for (std::uint32_t f = 0; f < complex.interfaces.size(); ++f) {
    const Triangle& face = complex.interfaces[f].triangle;
    table(face[0], face[1], face[2]) = f;
  }
  std::vector<ElementFace> elements(complex.interfaces.size());
  std::size_t found = 0;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t f = table(tetrahedra[t][outward_face[i][0]], tetrahedra[t][outward_face[i][1]],
                                    tetrahedra[t][outward_face[i][2]]);
      if (f == FaceTable::vacant || complex.interfaces[f].inner != complex.mesh.labels[t]) continue;
      elements[f] = {t, i};
      ++found;
    }
  if (found != elements.size()) throw InternalError("an interface of the complex is no face of its elements");
  return elements;
}

}  // namespace odontoscope
