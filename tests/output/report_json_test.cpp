#include "recon/output/report_json.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "tests/mesh/shapes.h"
#include "tests/output/models.h"

namespace odontoscope {
namespace {

using nlohmann::json;

TEST(ReportJson, HasEveryPromisedKeyInOrder) {
  const auto report = nlohmann::ordered_json::parse(report_json(models::tooth_and_enamel()));
  std::vector<std::string> keys;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"input", "tetrahedra", "surface", "structures", "resampling", "links",
                                            "void_links", "topology", "changes", "attention", "cut_links", "seconds",
                                            "threads", "certified", "verdict"}));
  for (const char* key : {"slices", "contours", "points", "steiner_points"})
    EXPECT_TRUE(report["input"].contains(key)) << key;
  for (const char* key :
       {"kept", "restored", "lifted_points", "trimmed", "volume", "dihedral_min_deg", "dihedral_max_deg"}) {
    EXPECT_TRUE(report["tetrahedra"].contains(key)) << key;
  }
  for (const char* key : {"vertices", "triangles", "boundary_edges", "nonmanifold_edges", "misoriented_edges",
                          "nonmanifold_vertices", "degenerate_triangles", "shells"}) {
    EXPECT_TRUE(report["surface"].contains(key)) << key;
  }
  for (const char* key : {"kind", "structure", "triangles", "genus", "volume"}) {
    EXPECT_TRUE(report["surface"]["shells"][0].contains(key)) << key;
  }
}

TEST(ReportJson, TellsWhatTheModelIs) {
  const json report = json::parse(report_json(models::tooth_and_enamel()));
  EXPECT_EQ(report["certified"], true);
  EXPECT_EQ(report["threads"], 2);
  EXPECT_EQ(report["input"]["points"], 812);
  EXPECT_EQ(report["input"]["steiner_points"], 17);
  EXPECT_EQ(report["seconds"]["validate"], 1.0);  // both of its parts
  EXPECT_EQ(report["resampling"], (json{{"exact", true}, {"slices_checked", 4}}));
  EXPECT_EQ(report["links"][1], (json{{"structure", "enamel"},
                                      {"slice", 2},
                                      {"lower", 3},
                                      {"upper", 4},
                                      {"connect", true},
                                      {"criterion", "user"}}));
  const json& shells = report["surface"]["shells"];
  ASSERT_EQ(shells.size(), 3u);
  EXPECT_EQ(shells[1]["kind"], "cavity");
  EXPECT_EQ(shells[2]["structure"], "enamel");
  EXPECT_EQ(shells[2]["genus"], 1);
  EXPECT_NEAR(report["tetrahedra"]["volume"], 2, 1e-12);  // two cubes
  EXPECT_NEAR(report["tetrahedra"]["dihedral_max_deg"], 90, 1e-6);
  EXPECT_FALSE(report.contains("simplification"));
}

TEST(ReportJson, ABrokenSurfaceIsNotCertified) {
  Reconstruction model = models::tooth_and_enamel();
  model.solids[1] = models::solid("enamel", shapes::holed(shapes::cube()));
  EXPECT_EQ(json::parse(report_json(model))["certified"], false);
}

TEST(ReportJson, TellsTheVerdictAndWhereToLook) {
  Reconstruction model = models::tooth_and_enamel();
  EXPECT_EQ(json::parse(report_json(model))["verdict"], "green");
  model.attention.push_back({.kind = AttentionKind::gap,
                             .structure = "tooth",
                             .slice = 1,
                             .last_slice = 2,
                             .z_lower = 0.5,
                             .z_upper = 1,
                             .place = {1, 2, 0.75},
                             .expected = {2, 0, 0},
                             .found = {2, 1, 0},
                             .seen = "a piece ends.",
                             .links = {{"tooth", 1, 0, 3, true}},
                             .remedy = "Join them."});
  model.changes.push_back({SlabChange::Kind::trimmed, "enamel", 2, 1, 1.5, {4, 5, 1.25}, 0.125, 7});
  model.changes.push_back({SlabChange::Kind::interpolated, "enamel", 3, 1.5, 2, {4, 5, 1.75}, 8, 3});
  const json report = json::parse(report_json(model));
  EXPECT_EQ(report["verdict"], "amber");
  const json& item = report["attention"].at(0);
  EXPECT_EQ(item["kind"], "gap");
  EXPECT_EQ(item["slice"], 1);
  EXPECT_EQ(item["last_slice"], 2);
  EXPECT_EQ(item["z"], (json{0.5, 1.0}));
  EXPECT_EQ(item["at"], (json{1.0, 2.0, 0.75}));
  EXPECT_EQ(item["expected"]["euler"], 2);
  EXPECT_EQ(item["found"]["euler"], 1);
  EXPECT_EQ(item["remedy"], "Join them.");
  EXPECT_EQ(item["links"],
            (json{{{"structure", "tooth"}, {"slice", 1}, {"lower", 0}, {"upper", 3}, {"connect", true}}}));
  EXPECT_EQ(report["changes"].at(0), (json{{"kind", "trimmed"},
                                           {"structure", "enamel"},
                                           {"slice", 2},
                                           {"z", {1.0, 1.5}},
                                           {"at", {4.0, 5.0, 1.25}},
                                           {"volume", 0.125},
                                           {"tetrahedra", 7}}));
  EXPECT_EQ(report["changes"].at(1)["slices"], 3);
  model.solids[1] = models::solid("enamel", shapes::holed(shapes::cube()));
  EXPECT_EQ(json::parse(report_json(model))["verdict"], "red");
}

TEST(ReportJson, TellsOfSimplifying) {
  ReportOptions options;
  options.simplifications.push_back({"tooth", 1000, 80, {{0.5, 0.1}, {0.4, 0.2}}, 0, 12, 30});
  options.aim = SimplificationAim{50, 80, {3, 4, 5}, 0};
  const json one = json::parse(report_json(models::tooth_and_enamel(), options))["simplification"].at(0);
  EXPECT_EQ(one["largest_distance"], 0.5);
  EXPECT_EQ(one["mean_distance"], 0.2);
  EXPECT_EQ(one["simplified_to_full"]["mean"], 0.1);
  EXPECT_EQ(one["triangles_before"], 1000);
  const json aim = json::parse(report_json(models::tooth_and_enamel(), options))["simplification_aim"];
  EXPECT_EQ(aim["reached"], false);
  EXPECT_EQ(aim["triangles"], 80);
  EXPECT_EQ(aim["edges_held_by"]["self_intersection"], 4);
}

TEST(ReportJson, TellsOfTheVolume) {
  ReportOptions options;
  EXPECT_FALSE(json::parse(report_json(models::tooth_and_enamel(), options)).contains("volume"));
  options.volume = ReportVolume{{{"tooth", 129.5}, {"enamel", 200}}, {"1 mm is assumed"}};
  const json volume = json::parse(report_json(models::tooth_and_enamel(), options))["volume"];
  EXPECT_EQ(volume["isos"]["tooth"], 129.5);
  EXPECT_EQ(volume["remarks"].at(0), "1 mm is assumed");
  EXPECT_FALSE(volume.contains("upright"));
  options.volume->upright = turn_to_z({0.6, 0, 0.8}, {1, 2, 3});
  options.volume->as_given = true;
  const json upright = json::parse(report_json(models::tooth_and_enamel(), options))["volume"]["upright"];
  const std::array row{0.8, 0.0, -0.6, 2.0};  // 1 - (0.8 * 1 - 0.6 * 3)
  for (std::size_t i = 0; i < row.size(); ++i) EXPECT_NEAR(upright["matrix"][0][i].get<double>(), row[i], 1e-15);
  EXPECT_EQ(upright["matrix"][3], json({0.0, 0.0, 0.0, 1.0}));
  EXPECT_NEAR(upright["degrees"], 36.8699, 1e-4);
  EXPECT_EQ(upright["as_given"], true);
}

TEST(ReportJson, TheSameBytesButForTimes) {
  const Reconstruction model = models::tooth_and_enamel();
  EXPECT_EQ(report_json(model), report_json(model));
}

TEST(SurfaceReportJson, JudgesAFile) {
  const json good = json::parse(surface_report_json("a.stl", {{"", inspect(shapes::cube())}}));
  EXPECT_EQ(good["closed_oriented_manifold"], true);
  EXPECT_EQ(good["surface"]["triangles"], 12);
  EXPECT_TRUE(good["meshes"][0].contains("smallest_angle_deg"));
  const json bad = json::parse(surface_report_json(
      "a.stl", {{"whole", inspect(shapes::cube())}, {"open", inspect(shapes::holed(shapes::cube()))}}));
  EXPECT_EQ(bad["closed_oriented_manifold"], false);
  EXPECT_EQ(bad["surface"]["boundary_edges"], 3);
  EXPECT_TRUE(bad["meshes"][1]["shells"][0]["genus"].is_null());
  EXPECT_EQ(json::parse(surface_report_json("a.stl", {}))["closed_oriented_manifold"], false);
}

}  // namespace
}  // namespace odontoscope
