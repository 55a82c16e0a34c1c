#include "engine/app/structure_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/app/version.h"
#include "engine/app/words.h"
#include "recon/core/limits.h"
#include "recon/segmentation/rasterise.h"
#include "recon/segmentation/structures_file.h"
#include "recon/segmentation/write_label_map.h"
#include "recon/segmentation/write_rtstruct.h"
#include "recon/segmentation/write_seg.h"
#include "recon/volume/volume_contours.h"

namespace odontoscope::app {
namespace {

const WrittenBy written_by{ODONTOSCOPE_VERSION};

std::optional<Point3> origin_in(const VoxelWords& words) {
  if (words.origin.empty()) return std::nullopt;
  std::array<double, 3> three{};
  const char* at = words.origin.data();
  const char* end = at + words.origin.size();
  for (std::size_t n = 0; n < 3; ++n) {
    const auto [next, error] = std::from_chars(at, end, three[n]);
    const bool well_ended = n < 2 ? next != end && *next == ',' : next == end;
    if (error != std::errc{} || !well_ended || !(std::abs(three[n]) <= limits::largest_coordinate)) {
      throw UsageError(
          fmt::format("--voxel-origin {}: that is no place", words.origin.substr(0, limits::quoted_length)),
          "Give three numbers in mm, as in -10,-12.5,0");
    }
    at = next + 1;
  }
  return Point3{three[0], three[1], three[2]};
}

/// Slices of voxels are those of the stack.
VoxelGrid grid_for(const ContourStack& stack, const VoxelWords& words, const Whence& whence) {
  if (words.size.empty()) return *whence.grid;
  const std::array<double, 3> size = parse_spacing(words.size);
  const std::optional<Point3> origin = origin_in(words);
  const Point2 first = origin ? Point2{origin->x, origin->y} : Point2{};
  const VoxelGrid grid = grid_of_slices(stack, size[0], size[1], origin ? &first : nullptr);
  const double step = grid.spacing[2];
  if (std::abs(size[2] - step) > limits::slice_unevenness * step) {
    throw UsageError(fmt::format("--voxels {}: the slices lie {:.6g} mm apart, and contours say nothing between them",
                                 words.size, step),
                     fmt::format("Give --voxels {:.6g},{:.6g},{:.6g}, or let reconstruct write the voxels: it fills "
                                 "the space between slices",
                                 size[0], size[1], step));
  }
  if (origin && std::abs(origin->z - grid.origin.z) > limits::slice_unevenness * step) {
    throw UsageError(
        fmt::format("--voxel-origin {}: the first slice lies at z = {:.6g} mm", words.origin, grid.origin.z),
        "Begin there, or let reconstruct write the voxels");
  }
  return grid;
}

Box3 box_of(const Reconstruction& model) {
  constexpr double far = 2 * limits::largest_coordinate;
  Box3 box{{far, far, far}, {-far, -far, -far}};
  for (const Solid& solid : model.solids) {
    for (const Point3& p : solid.tetrahedra.points) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
  }
  return box;
}

VoxelGrid grid_for(const Reconstruction& model, const VoxelWords& words, const Whence& whence) {
  if (words.size.empty()) return *whence.grid;
  const std::array<double, 3> size = parse_spacing(words.size);
  const std::optional<Point3> origin = origin_in(words);
  return origin ? grid_from(*origin, box_of(model), size) : grid_around(box_of(model), size);
}

void tell_voxels(const Segmentation& segmentation, const std::string& file, StructuresFormat format, Console& console) {
  const VoxelGrid& grid = segmentation.grid;
  const double volume = grid.spacing[0] * grid.spacing[1] * grid.spacing[2];
  std::vector<std::string> parts;
  for (const Segment& segment : segmentation.segments) {
    const std::size_t count = segment.voxels.count();
    parts.push_back(fmt::format("{}: {} ({} mm^3)", segment.name, counted(count, "voxel"),
                                measured(static_cast<double>(count) * volume)));
    if (count == 0)
      console.complain(
          fmt::format("warning: no voxel's centre lies in {}; it is missing from {}.", segment.name, file));
  }
  console.say(fmt::format("{}: {} x {} x {} voxels of {} x {} x {} mm; {}", file, grid.size[0], grid.size[1],
                          grid.size[2], measured(grid.spacing[0]), measured(grid.spacing[1]), measured(grid.spacing[2]),
                          fmt::join(parts, "; ")));
  if (format != StructuresFormat::label_map) return;
  if (const std::size_t overlap = overlapping_voxels(segmentation); overlap > 0) {
    console.say(fmt::format("  {} in more than one structure; a label map gives each to the one named last here",
                            counted(overlap, "voxel lies", "voxels lie")));
  }
}

void tell_study(const std::string& file, const Whence& whence, Console& console) {
  if (!whence.patient.dicom)
    console.say(fmt::format("  {} belongs to a new study without a patient: what was read is no DICOM", file));
}

std::string bytes_of(const Segmentation& segmentation, StructuresFormat format, const std::string& file,
                     const Whence& whence, Session& session) {
  if (segmentation.segments.size() > limits::structures) throw InternalError("more segments than structures can be");
  std::string bytes = format == StructuresFormat::seg ? seg_bytes(segmentation, whence.patient, written_by)
                                                      : label_map_bytes(segmentation, whence.patient.frame);
  tell_voxels(segmentation, file, format, session.console);
  if (format == StructuresFormat::seg) tell_study(file, whence, session.console);
  return bytes;
}

std::string rtstruct_told(const ContourStack& stack, const std::string& file, const Whence& whence, Session& session) {
  std::string bytes = rtstruct_bytes(stack, whence.patient, written_by);
  tell_study(file, whence, session.console);
  const auto empty = static_cast<std::size_t>(std::count_if(stack.slices.begin(), stack.slices.end(),
                                                            [](const Slice& slice) { return slice.contours.empty(); }));
  if (empty > 0)
    session.console.say(fmt::format(
        "  {} without contours; a structure set has no place for that, and whoever reads it knows nothing of them",
        counted(empty, "slice is", "slices are")));
  return bytes;
}

}  // namespace

void add_voxel_options(CLI::App& parser, VoxelWords& words) {
  const std::string group = "Voxels (.seg.dcm, .nrrd)";
  parser
      .add_option("--voxels", words.size, "Size of a voxel to write, mm (default: those of the volume that was read)")
      ->type_name("X,Y,Z")
      ->group(group);
  parser
      .add_option("--voxel-origin", words.origin,
                  "Centre of the first voxel, mm (default: one voxel before the structures)")
      ->type_name("X,Y,Z")
      ->group(group);
}

bool is_structures_file(const std::string& file) { return structures_format(file).has_value(); }

void refuse_senseless(const VoxelWords& words, const std::vector<std::string>& outputs, bool of_volume) {
  const auto voxels = std::find_if(outputs.begin(), outputs.end(), [](const std::string& file) {
    const auto format = structures_format(file);
    return format && has_voxels(*format);
  });
  const bool any_words = !words.size.empty() || !words.origin.empty();
  if (voxels == outputs.end()) {
    if (any_words)
      throw UsageError("--voxels and --voxel-origin are about files of voxels",
                       "Write one: -o tooth.seg.nrrd, or -o tooth.seg.dcm");
    return;
  }
  if (!words.size.empty()) parse_spacing(words.size);
  origin_in(words);
  if (!words.origin.empty() && words.size.empty())
    throw UsageError("--voxel-origin is about --voxels", "Add --voxels X,Y,Z");
  if (words.size.empty() && !of_volume)
    throw UsageError(fmt::format("{}: nothing says how large its voxels are", *voxels), "Give --voxels X,Y,Z, in mm");
}

void refuse_reshaped(const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs) {
    if (!is_structures_file(output)) continue;
    throw UsageError(
        fmt::format("{} refers to the volume as the file has it, and --crop, --resample and --upright change that",
                    output),
        "Leave them out, or write contours (.json) or a model");
  }
}

FileContent structures_file(const ContourStack& stack, const std::string& file, const VoxelWords& words,
                            const Whence& whence, Session& session) {
  const StructuresFormat format = *structures_format(file);
  if (format == StructuresFormat::rtstruct) return {file, rtstruct_told(stack, file, whence, session)};
  return {file, bytes_of(rasterised(stack, grid_for(stack, words, whence), session.progress()), format, file, whence,
                         session)};
}

FileContent structures_file(const Reconstruction& model, const ContourStack& stack, const std::string& file,
                            const VoxelWords& words, const Whence& whence, Session& session) {
  const StructuresFormat format = *structures_format(file);
  if (format == StructuresFormat::rtstruct) return {file, rtstruct_told(stack, file, whence, session)};
  std::vector<FilledSurface> surfaces;
  for (const Solid& solid : model.solids) surfaces.push_back({solid.structure, &solid.surface});
  return {file, bytes_of(rasterised(surfaces, grid_for(model, words, whence), session.progress()), format, file, whence,
                         session)};
}

}  // namespace odontoscope::app
