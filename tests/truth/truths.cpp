#include "truths.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "recon/core/error.h"
#include "recon/distance/marching_cubes.h"
#include "recon/exchange/cut_surfaces.h"
#include "recon/formats/read_mesh.h"

namespace odontoscope::test {
namespace {

constexpr double surface_step = 0.06;  // mm; of the true surface, which then cuts the narrowest canal by 0.003 mm

std::vector<SurfaceMesh> surfaces_of(const TurnedTooth& tooth) {
  const Grid grid = tooth.own_grid(surface_step);
  std::array<std::vector<double>, structure_count> values = tooth.own_values(grid);
  std::vector<SurfaceMesh> surfaces;
  for (std::size_t s = 0; s < structure_count; ++s) {
    SurfaceMesh mesh = march(grid, {structure_names[s], std::move(values[s])}, CaseTable::consistent).mesh;
    for (Point3& point : mesh.points) point = tooth.to_image(point);
    surfaces.push_back(std::move(mesh));
  }
  return surfaces;
}

}  // namespace

const std::vector<double>& usual_steps() {
  static const std::vector<double> steps{0.06, 0.05, 0.04, 0.032};
  return steps;
}

std::optional<std::vector<Topology>> counted_topology(const TurnedTooth& tooth, const std::vector<double>& steps) {
  std::optional<std::vector<Topology>> last;
  for (const double step : steps) {
    const Voxels voxels = tooth.own_voxels(tooth.own_grid(step));
    std::vector<Topology> found;
    for (std::size_t s = 0; s < structure_count; ++s)
      found.push_back(topology_of(voxels, static_cast<std::uint8_t>(1u << s)));
    if (found == last) return found;
    last = std::move(found);
  }
  return std::nullopt;
}

Truth tooth_truth(const TurnedTooth& tooth, std::vector<Topology> topology, double raster_step) {
  Truth truth;
  truth.names.assign(structure_names.begin(), structure_names.end());
  truth.topology = std::move(topology);
  truth.raster = tooth.raster(raster_step);
  truth.masks = [&tooth, raster = truth.raster](const std::vector<double>& heights) {
    std::vector<Mask> masks;
    for (const double z : heights) masks.push_back(tooth.mask(raster, z));
    return masks;
  };
  // Made once, on the first call; copies of the truth share it.
  truth.surfaces = [&tooth, known = std::make_shared<std::vector<SurfaceMesh>>()] {
    if (known->empty()) *known = surfaces_of(tooth);
    return *known;
  };
  return truth;
}

std::vector<double> RealTooth::heights(double spacing) const {
  std::vector<NamedMesh> all;
  for (const Part& part : parts_) all.push_back(part.mesh);
  return heights_at(all, spacing);
}

ContourStack RealTooth::cut(const std::vector<double>& heights) const {
  ContourStack stack;
  for (const double z : heights) stack.slices.push_back({z, {}});
  for (const Part& part : parts_) {
    const ContourStack own =
        cut_surfaces({part.mesh}, heights, part.mesh.name, {.repair = part.repair, .widest_gap = part.widest_gap})
            .stack;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      auto& contours = stack.slices[i].contours;
      contours.insert(contours.end(), own.slices[i].contours.begin(), own.slices[i].contours.end());
    }
  }
  return stack;
}

ContourStack RealTooth::contours(double spacing) const { return cut(heights(spacing)); }

Raster RealTooth::raster(double step) const {
  constexpr double margin = 0.3;
  Point2 low{1e9, 1e9}, high{-1e9, -1e9};
  for (const Part& part : parts_) {
    for (const Point3& p : part.mesh.surface.points) {
      low = {std::min(low.x, p.x - margin), std::min(low.y, p.y - margin)};
      high = {std::max(high.x, p.x + margin), std::max(high.y, p.y + margin)};
    }
  }
  return {low.x, low.y, step, static_cast<std::size_t>((high.x - low.x) / step) + 1,
          static_cast<std::size_t>((high.y - low.y) / step) + 1};
}

std::vector<Topology> RealTooth::count(double step) const {
  const Raster grid = raster(step);
  const ContourStack stack = cut(heights(step));
  std::vector<Topology> found;
  for (const Part& part : parts_) {
    Voxels voxels(grid.columns, grid.rows, 0);
    for (const Slice& slice : stack.slices) {
      const Mask mask = inside_contours(grid, slice, part.mesh.name);
      voxels.values.insert(voxels.values.end(), mask.begin(), mask.end());
      ++voxels.layers;
    }
    found.push_back(topology_of(voxels, 1));
  }
  return found;
}

Truth RealTooth::truth() const {
  constexpr double count_step = 0.05, raster_step = 0.05;
  Truth truth;
  for (const Part& part : parts_) truth.names.push_back(part.mesh.name);
  truth.topology = count(count_step);
  truth.raster = raster(raster_step);
  truth.masks = [this, raster = truth.raster](const std::vector<double>& heights) {
    const ContourStack stack = cut(heights);
    std::vector<Mask> masks;
    for (const Slice& slice : stack.slices) {
      Mask bits(raster.size(), 0);
      for (std::size_t s = 0; s < parts_.size(); ++s) {
        const Mask mask = inside_contours(raster, slice, parts_[s].mesh.name);
        for (std::size_t p = 0; p < mask.size(); ++p) bits[p] = static_cast<std::uint8_t>(bits[p] | mask[p] << s);
      }
      masks.push_back(std::move(bits));
    }
    return masks;
  };
  truth.surfaces = [this] {
    std::vector<SurfaceMesh> surfaces;
    for (const Part& part : parts_) surfaces.push_back(part.mesh.surface);
    return surfaces;
  };
  return truth;
}

std::optional<RealTooth> incisor_meshes(const std::string& folder) {
  if (!std::filesystem::exists(folder + "/URI1_pulp.stl")) return std::nullopt;
  const auto part = [&](const char* file, const char* name, bool repair, double widest_gap) {
    return RealTooth::Part{{name, read_mesh(folder + "/URI1_" + file + ".stl").at(0).surface}, repair, widest_gap};
  };
  return RealTooth(
      {part("enamel", "enamel", true, 7), part("dentin", "dentine", true, 0.5), part("pulp", "pulp", false, 0.5)});
}

}  // namespace odontoscope::test
