#include "engine/app/web_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assets/theme.h"
#include "engine/app/shown_values.h"
#include "engine/scene/scene_json.h"
#include "recon/core/grouped.h"
#include "recon/formats/write_glb.h"
#include "recon/radiograph/tissue.h"

namespace odontoscope::app {
namespace {

constexpr double levels = 255;
constexpr std::size_t bar_count = 64;

ValueWindow window_in_bytes(const ValueGrid& grid, const GreyAnchors& greys) {
  const bool whole =
      std::all_of(grid.values.begin(), grid.values.end(), [](float value) { return value == std::round(value); });
  if (whole && grid.range.high - grid.range.low <= levels) return {grid.range.low, grid.range.low + levels};
  const double contrast = greys.dentine - greys.air, low = std::max(grid.range.low, greys.air - 0.5 * contrast),
               high = std::min(grid.range.high, greys.air + 3.5 * contrast);
  return {low, std::max(high, low + 1e-6 * contrast)};
}

/// By the logarithm of how many values there are, as in the viewer.
std::vector<double> bars_of(const std::string& bytes) {
  std::array<double, bar_count> counts{};
  for (const char byte : bytes) ++counts[static_cast<unsigned char>(byte) * bar_count / 256];
  double most = 1;
  for (double& count : counts) {
    count = std::log1p(count);
    most = std::max(most, count);
  }
  std::vector<double> bars;
  for (const double count : counts) bars.push_back(std::round(1000 * count / most) / 1000);
  return bars;
}

nlohmann::json json_of(const VolumeLook& look) {
  Scene scene;
  scene.volume = look;
  return nlohmann::json::parse(to_json(scene)).at("volume");
}

}  // namespace

WebVolume web_volume(const ValueGrid& grid, const GreyAnchors& greys, const VolumeLook& look) {
  const ValueWindow window = window_in_bytes(grid, greys);
  WebVolume volume;
  volume.size = grid.size;
  volume.first_mm = {grid.first_mm.x, grid.first_mm.y, grid.first_mm.z};
  volume.step_mm = {grid.step_mm.x, grid.step_mm.y, grid.step_mm.z};
  volume.low = window.low;
  volume.high = window.high;
  volume.bytes.reserve(grid.values.size());
  for (const float value : grid.values)
    volume.bytes.push_back(static_cast<char>(static_cast<unsigned char>(std::lround(
        std::clamp(levels * (static_cast<double>(value) - window.low) / (window.high - window.low), 0.0, levels)))));
  volume.air = greys.air;
  volume.dentine = greys.dentine;
  volume.dentine_attenuation = linear_attenuation(*tissue_called("dentine"), effective_energy_kev(usual_kv));
  volume.bars = bars_of(volume.bytes);
  volume.look = json_of(look).dump();
  for (const TransferPreset preset : {TransferPreset::tooth, TransferPreset::enamel, TransferPreset::dentine,
                                      TransferPreset::pulp, TransferPreset::soft}) {
    VolumeLook ready = look;
    ready.transfer = transfer_of(preset, greys.air, greys.dentine);
    volume.transfers.emplace_back(name(preset), json_of(ready).at("transfer").dump());
  }
  return volume;
}

void tell_web_volume(const WebVolume& volume, const ValueGrid& grid, Session& session) {
  session.console.say(fmt::format("The page carries {} x {} x {} values of 8 bits: {} KB of it", volume.size[0],
                                  volume.size[1], volume.size[2], grouped(packed_size(volume) / 1000)));
  if (volume.low > grid.range.low || volume.high < grid.range.high)
    session.console.say(fmt::format("  from {:.6g} to {:.6g}, in steps of {:.3g}; what lies beyond counts as these",
                                    volume.low, volume.high, (volume.high - volume.low) / levels));
}

PageGreys page_greys(const Volume& volume, const ContourStack& stack, const ReportVolume& facts) {
  PageGreys greys;
  greys.anchors = grey_anchors(volume);
  greys.values =
      std::make_shared<const ValueGrid>(value_grid(volume, with_margin(bounds_of(stack), volume), page_values));
  for (const auto& [structure, iso] : facts.isos) greys.isos.push_back({structure, iso});
  return greys;
}

void add_greys(const PageGreys& greys, const VolumeLookWords& look, const std::string& grey, Scene& scene,
               WebPage& page, Session& session) {
  Shown shown;
  shown.values = greys.values;
  shown.greys = greys.anchors;
  show_volume({look, grey, usual_kv, {}, false}, shown, scene, session);
  page.volume = web_volume(*greys.values, greys_from(grey).value_or(greys.anchors), scene.volume);
  page.volume->isos = greys.isos;
  tell_web_volume(*page.volume, *greys.values, session);
}

WebPage page_of_voxels(const VoxelsAlone& voxels, const VolumeLookWords& look, const std::string& grey,
                       Session& session) {
  Shown shown;
  shown.greys = voxels.greys;
  shown.only_voxels = true;
  shown.values = voxels.values;
  Scene scene;
  show_volume({look, grey, usual_kv, {}, false}, shown, scene, session);
  WebPage page;
  page.volume = web_volume(*voxels.values, greys_from(grey).value_or(voxels.greys), scene.volume);
  page.volume->alone = true;
  tell_web_volume(*page.volume, *voxels.values, session);
  WrittenModel box;
  const SurfaceMesh surface = box_surface(voxels.dense);
  const SurfaceReport report = inspect(surface);
  box.solids.push_back({"volume", surface, report});
  WebModel model;
  model.name = "CT";
  model.words = "Grey values, as they were read.";
  model.glb = glb_bytes(box);
  model.triangles = surface.triangles.size();
  model.certificate.verdict = "sound";
  model.certificate.headline = "Grey values, as they were read; no surface was made of them.";
  page.models.push_back(std::move(model));
  page.looks.push_back({"volume", hex(colour_of(assets::theme::tissues::tooth))});
  return page;
}

}  // namespace odontoscope::app
