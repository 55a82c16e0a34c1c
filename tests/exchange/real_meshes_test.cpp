// A human incisor's meshes, open and torn as they are: cut, reconstructed, and how far off that is.

#include <gtest/gtest.h>

#include <filesystem>

#include "recon/core/error.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/exchange/cut_surfaces.h"
#include "recon/formats/read_mesh.h"
#include "recon/mesh/surface_distance.h"

namespace odontoscope {
namespace {

class Incisor : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::string(ODONTOSCOPE_DATA).empty() || !std::filesystem::exists(file("pulp"))) {
      GTEST_SKIP() << "the incisor is not there; set the CMake variable ODONTOSCOPE_DATA";
    }
  }
  static std::string file(const std::string& part) {
    return std::string(ODONTOSCOPE_DATA) + "/incisor_meshes/URI1_" + part + ".stl";
  }

  struct Made {
    Reconstruction model;
    OneWayDistance off;  // from the mesh's vertices to the model
    std::vector<ContourChange> changes;
  };
  static Made made(const std::string& part, const CutOptions& options) {
    const std::vector<NamedMesh> surfaces{{part, read_mesh(file(part)).at(0).surface}};
    CutContours cut = cut_surfaces(surfaces, heights_at(surfaces, 0.2), file(part), options);
    Made made{reconstruct(cut.stack), {}, std::move(cut.changes)};
    made.off = distance_to_surface(surfaces[0].surface.points, made.model.solids.at(0).surface).value();
    RecordProperty(part, "off by " + std::to_string(made.off.mean) + " mm on average, " +
                             std::to_string(made.off.largest) + " at most");
    std::printf("%s: off by %.4f mm on average, %.3f at most, %zu changes\n", part.c_str(), made.off.mean,
                made.off.largest, made.changes.size());
    return made;
  }
  static std::string refusal(const std::string& part) {
    try {
      made(part, {});
      return "accepted";
    } catch (const InputError& error) {
      return error.cause();
    }
  }
};

TEST_F(Incisor, PulpIsClosedAndComesBack) {
  const Made pulp = made("pulp", {});
  EXPECT_TRUE(pulp.model.certified);
  EXPECT_TRUE(pulp.changes.empty());
  EXPECT_LT(pulp.off.mean, 0.01);
  EXPECT_LT(pulp.off.largest, 0.2);  // horns and apex between planes 0.2 mm apart
}

TEST_F(Incisor, DentineIsTornAndMended) {
  EXPECT_EQ(refusal("dentin"), "open-surface");
  const Made dentine = made("dentin", {.repair = true});
  EXPECT_TRUE(dentine.model.certified);
  EXPECT_EQ(dentine.changes.size(), 4u);
  EXPECT_LT(dentine.off.mean, 0.01);
  EXPECT_LT(dentine.off.largest, 0.2);
}

TEST_F(Incisor, EnamelIsAnOpenCap) {
  EXPECT_EQ(refusal("enamel"), "open-surface");
  EXPECT_THROW(made("enamel", {.repair = true}), InputError);
  const Made enamel = made("enamel", {.repair = true, .widest_gap = 7});
  EXPECT_TRUE(enamel.model.certified);
  EXPECT_GT(enamel.changes.size(), 30u);
  EXPECT_LT(enamel.off.mean, 0.01);
}

}  // namespace
}  // namespace odontoscope
