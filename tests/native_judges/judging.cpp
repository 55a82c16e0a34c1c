#include "tests/native_judges/judging.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <utility>

#include "recon/contours/simplify_contours.h"
#include "recon/mesh/tetra_report.h"
#include "recon/output/model_file.h"
#include "recon/sample/sample_tooth.h"
#include "recon/volume/iso_contours.h"
#include "recon/volume/read_volume.h"
#include "tests/support/shell.h"

namespace odontoscope::judges {
namespace {

const std::filesystem::path ct_file = std::filesystem::path(ODONTOSCOPE_DATA) / "ct_molar" / "tooth.nrrd";

ContourStack ct_contours() {
  return iso_contours(read_volume(ct_file.string()), {{120, "tooth"}}, {.min_area = 4}).stack;
}

ContourStack without(ContourStack stack, const std::string& structure) {
  for (Slice& slice : stack.slices) {
    std::erase_if(slice.contours, [&](const Contour& contour) { return contour.structure == structure; });
  }
  return stack;
}

using testing_support::run;
using testing_support::Said;

}  // namespace

void Judge::need(const std::string& program) {
  if (GetParam() == Tooth::ct_molar && (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(ct_file))) {
    GTEST_SKIP() << "the CT molar is not there; set the CMake variable ODONTOSCOPE_DATA";
  }
  if (run("command -v " + program).exit_code != 0) {
    GTEST_SKIP() << program << " is not installed; third_party/test_packages.debian lists it under \"judges\"";
  }
}

const Reconstruction& Judge::tooth() const {
  static std::map<Tooth, Reconstruction> made;
  const auto at = made.find(GetParam());
  if (at != made.end()) return at->second;
  const bool sample = GetParam() == Tooth::sample_molar;
  return made
      .emplace(GetParam(),
               reconstruct(sample ? sample_tooth(ToothKind::molar, {.walls = SampleWalls::apart}) : ct_contours()))
      .first->second;
}

std::string Judge::file_of(const Reconstruction& model, const std::string& name) const {
  const std::filesystem::path file = folder / name;
  write_model(model, {&file, 1});
  return file.string();
}

std::string Judge::said_by(const std::string& command) const {
  const Said said = run("cd '" + folder.path().string() + "' && " + command);
  EXPECT_EQ(said.exit_code, 0) << command << "\n" << said.words;
  return said.words;
}

Reconstruction coarse_tooth(Tooth tooth) {
  if (tooth == Tooth::ct_molar) return reconstruct(simplify_contours(ct_contours(), {0.4}).stack);
  const ContourStack all = sample_tooth(ToothKind::molar, {.slice_spacing = 0.35, .point_spacing = 0.9});
  return reconstruct(without(without(all, "enamel"), "pulp"));
}

double number_after(const std::string& text, const std::string& label) {
  std::size_t at = text.find(label);
  if (at == text.npos) {
    ADD_FAILURE() << "\"" << label << "\" is not in:\n" << text;
    return -1;
  }
  at = text.find_first_not_of(" :=", at + label.size());
  return std::strtod(text.c_str() + at, nullptr);
}

Reconstruction with_flipped_triangle(Reconstruction model) {
  auto& triangles = model.solids.front().surface.triangles;
  std::swap(triangles[triangles.size() / 2][0], triangles[triangles.size() / 2][1]);
  return model;
}

Reconstruction without_a_triangle(Reconstruction model) {
  Solid& solid = model.solids.front();
  solid.surface.triangles.erase(solid.surface.triangles.begin() +
                                static_cast<std::ptrdiff_t>(solid.surface.triangles.size() / 2));
  solid.report = inspect(solid.surface);
  return model;
}

Reconstruction with_inverted_tetrahedron(Reconstruction model) {
  auto& tetrahedra = model.solids.front().tetrahedra.tetrahedra;
  std::swap(tetrahedra[tetrahedra.size() / 2][0], tetrahedra[tetrahedra.size() / 2][1]);
  return model;
}

Reconstruction without_a_tetrahedron(Reconstruction model) {
  TetraMesh& mesh = model.solids.front().tetrahedra;
  mesh.tetrahedra.pop_back();
  mesh.labels.pop_back();
  return model;
}

std::size_t triangles_in(const Reconstruction& model) {
  std::size_t sum = 0;
  for (const Solid& solid : model.solids) sum += solid.surface.triangles.size();
  return sum;
}

std::size_t tetrahedra_in(const Reconstruction& model) {
  std::size_t sum = 0;
  for (const Solid& solid : model.solids) sum += solid.tetrahedra.tetrahedra.size();
  return sum;
}

double volume_of(const Reconstruction& model) {
  double sum = 0;
  for (const Solid& solid : model.solids) sum += inspect(solid.tetrahedra).volume;
  return sum;
}

std::string name_of(const ::testing::TestParamInfo<Tooth>& tooth) {
  return tooth.param == Tooth::sample_molar ? "SampleMolar" : "CtMolar";
}

}  // namespace odontoscope::judges
