#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "engine/app/sniff.h"
#include "engine/app/volume_options.h"
#include "python/binding/arrays.h"
#include "python/binding/parts.h"
#include "python/binding/session.h"
#include "python/binding/watched.h"
#include "recon/contours/simplify_contours.h"
#include "recon/core/atomic_file.h"
#include "recon/core/read_file.h"
#include "recon/exchange/contour_file.h"
#include "recon/exchange/cut_surfaces.h"
#include "recon/exchange/repair_contours.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope::python {
namespace {

using Points = py::array_t<double, py::array::c_style>;

Contour copied(const std::string& structure, const Points& points) {
  Contour contour{structure, std::vector<Point2>(static_cast<std::size_t>(points.shape(0)))};
  const auto at = points.unchecked<2>();
  for (py::ssize_t i = 0; i < points.shape(0); ++i) contour.points[static_cast<std::size_t>(i)] = {at(i, 0), at(i, 1)};
  return contour;
}

/// Contours of one height make a slice, in order of first appearance; a height without a contour is an empty one.
ContourStack stack_of(const py::list& contours, std::string source) {
  ContourStack stack{{}, std::move(source)};
  for (const py::handle item : contours) {
    const auto given = item.cast<py::tuple>();
    const double z = given[0].cast<double>();
    auto slice =
        std::find_if(stack.slices.rbegin(), stack.slices.rend(), [z](const Slice& one) { return one.z == z; }).base();
    if (slice == stack.slices.begin()) slice = stack.slices.insert(stack.slices.end(), Slice{z, {}}) + 1;
    if (!given[2].is_none())
      (slice - 1)->contours.push_back(copied(given[1].cast<std::string>(), given[2].cast<Points>()));
  }
  return stack;
}

Contours checked(ContourStack stack, bool repair, const Progress& progress) {
  Contours made;
  if (repair) {
    RepairedContours repaired = repair_contours(stack, {}, progress);
    for (const ContourChange& change : repaired.changes) made.changes.push_back(in_words(change));
    stack = std::move(repaired.stack);
  }
  validate(stack, progress);
  made.stack = std::make_shared<const ContourStack>(std::move(stack));
  return made;
}

struct ReadOptions {
  std::vector<std::string> structures;
  std::optional<double> spacing_z;
  std::vector<double> heights;
  bool repair = false;
  double widest_gap = CutOptions{}.widest_gap;
};

std::vector<NamedMesh> kept_surfaces(std::vector<NamedMesh> meshes, const std::vector<std::string>& structures,
                                     const std::string& file) {
  for (NamedMesh& mesh : meshes) mesh.name = mesh.name.empty() ? "tooth" : app::structure_of_mesh(mesh.name);
  if (structures.empty()) return meshes;
  ContourStack names{{{0, {}}}, file};  // so that unknown ones are said as everywhere
  for (const NamedMesh& mesh : meshes) names.slices.front().contours.push_back({mesh.name, {}});
  keep_structures(names, structures);
  std::erase_if(meshes, [&](const NamedMesh& mesh) {
    return std::find(structures.begin(), structures.end(), mesh.name) == structures.end();
  });
  return meshes;
}

Contours cut(std::vector<NamedMesh> meshes, const std::string& file, const ReadOptions& options,
             const Progress& progress) {
  if (!options.spacing_z && options.heights.empty())
    throw UsageError(file + " is a mesh, and nothing says where to cut it", "Give spacing_z, or at for each plane");
  Contours made;
  for (const NamedMesh& mesh : meshes)
    made.remarks.insert(made.remarks.end(), mesh.remarks.begin(), mesh.remarks.end());
  const std::vector<NamedMesh> surfaces = kept_surfaces(std::move(meshes), options.structures, file);
  std::vector<double> heights = options.spacing_z ? heights_at(surfaces, *options.spacing_z) : options.heights;
  std::sort(heights.begin(), heights.end());
  CutContours found = cut_surfaces(surfaces, heights, file, {options.repair, options.widest_gap}, progress);
  for (const ContourChange& change : found.changes) made.changes.push_back(in_words(change));
  made.stack = std::make_shared<const ContourStack>(found.stack);
  return made;
}

[[noreturn]] void refuse_unknown(const std::string& file) {
  Place place;
  place.file = file;
  throw InputError("unknown-format", std::move(place), "this is no volume, mesh or contour file that is known here",
                   "docs/formats.md lists the formats");
}

Contours read(const std::string& file, const ReadOptions& options, const Progress& progress) {
  const std::string bytes = read_file(file, limits::file_bytes, progress.stop);
  const app::FileKind kind = app::kind_of(bytes, file);
  const auto contour_kind = contour_file_kind(bytes);
  if ((contour_kind || kind == app::FileKind::contour_stack) && (options.spacing_z || !options.heights.empty()))
    throw UsageError(file + " holds contours, and spacing_z and at are about meshes", "Leave them out");
  if (contour_kind) {
    FileContours found = read_contour_file(*contour_kind, bytes, file, options.structures);
    Contours made = checked(std::move(found.stack), options.repair, progress);
    made.remarks = std::move(found.remarks);
    made.origin = std::make_shared<const Origin>(Origin{{}, {}, {std::move(found.patient), {}}});
    return made;
  }
  if (auto meshes = app::meshes_in(kind, bytes, file)) return cut(std::move(*meshes), file, options, progress);
  if (kind == app::FileKind::volume)
    throw UsageError(file + " is a volume, and nothing says where in it the surface lies",
                     "Give iso for an image, label for a label map");
  if (kind == app::FileKind::unknown) refuse_unknown(file);
  ContourStack stack = parse_stack(bytes, file);
  keep_structures(stack, options.structures);
  return checked(std::move(stack), options.repair, progress);
}

/// "volume", "mesh", "contours" or "unknown".
std::string kind_of_file(const std::string& file) {
  if (app::looks_like_a_volume(file)) return "volume";
  const std::string bytes = read_file(file);
  if (contour_file_kind(bytes)) return "contours";
  switch (app::kind_of(bytes, file)) {
    case app::FileKind::contour_stack:
      return "contours";
    case app::FileKind::volume:
      return "volume";
    case app::FileKind::unknown:
      return "unknown";
    default:
      return "mesh";
  }
}

Contours simplified(const Contours& given, double tolerance, const py::object& listener) {
  return watched(listener, [&](const Progress& progress) {
    Contours made = given;
    made.stack = std::make_shared<const ContourStack>(simplify_contours(*given.stack, {tolerance}, progress).stack);
    return made;
  });
}

Contours joined(const Contours& given, const std::vector<std::string>& structures) {
  Contours made = given;
  ContourStack stack = together(*given.stack, structures);
  validate(stack);
  made.stack = std::make_shared<const ContourStack>(std::move(stack));
  return made;
}

py::list slice_of(const Contours& contours, std::size_t number) {
  if (number >= contours.stack->slices.size()) throw py::index_error("no such slice");
  py::list list;
  for (const Contour& contour : contours.stack->slices[number].contours)
    list.append(py::make_tuple(contour.structure, table_view<double, 2>(contour.points, contours.stack)));
  return list;
}

/// As the file's ending asks: a contour stack, a structure set, a segmentation, a label map.
void write_contours(const Contours& contours, const std::string& file, const std::string& voxels,
                    const std::string& voxel_origin) {
  const app::VoxelWords words{voxels, voxel_origin};
  app::refuse_senseless(words, {file}, contours.origin && contours.origin->whence.grid);
  if (!app::is_structures_file(file)) return write_stack(*contours.stack, file);
  if (contours.origin && contours.origin->reshaped) app::refuse_reshaped({file});
  QuietSession session;
  {
    const py::gil_scoped_release unlocked;
    const app::Whence whence = contours.origin ? contours.origin->whence : app::Whence{};
    write_files(
        std::vector<FileContent>{app::structures_file(*contours.stack, file, words, whence, session.watched_by({}))});
  }
  session.warn();
}

std::vector<double> heights_of(const Contours& contours) {
  std::vector<double> heights;
  for (const Slice& slice : contours.stack->slices) heights.push_back(slice.z);
  return heights;
}

Contours sample(const std::string& kind, std::optional<double> slice_spacing, double point_spacing, bool apart,
                bool filled_dentine, bool filled, bool open_apex) {
  SampleOptions options;
  options.slice_spacing = slice_spacing;
  options.point_spacing = point_spacing;
  options.hollow_dentine = !filled_dentine;
  options.open_apex = open_apex;
  if (apart || filled_dentine) options.walls = SampleWalls::apart;
  if (filled) options.walls = SampleWalls::filled;
  for (const ToothKind known : {ToothKind::molar, ToothKind::premolar, ToothKind::incisor}) {
    if (kind == name(known)) return {std::make_shared<const ContourStack>(sample_tooth(known, options)), {}, {}, {}};
  }
  throw UsageError("\"" + kind + "\" is no sample tooth", "Say molar, premolar or incisor");
}

}  // namespace

void add_contours(py::module_& module) {
  py::class_<Contours, std::shared_ptr<Contours>>(module, "Contours")
      .def("slice", &slice_of)
      .def("heights", &heights_of)
      .def("structures", [](const Contours& self) { return structures_of(*self.stack); })
      .def("source", [](const Contours& self) { return self.stack->source; })
      .def_readonly("changes", &Contours::changes)
      .def_readonly("remarks", &Contours::remarks)
      .def("text", [](const Contours& self) { return to_json(*self.stack); })
      .def("write", &write_contours);
  module.def("stack", [](const py::list& contours, const std::string& source, bool repair, const py::object& listener) {
    ContourStack stack = stack_of(contours, source);
    return watched(listener, [&](const Progress& progress) { return checked(std::move(stack), repair, progress); });
  });
  module.def("read_contours", [](const std::string& file, const std::vector<std::string>& structures,
                                 std::optional<double> spacing_z, const std::vector<double>& heights, bool repair,
                                 std::optional<double> widest_gap, const py::object& listener) {
    ReadOptions options{structures, spacing_z, heights, repair};
    options.widest_gap = widest_gap.value_or(options.widest_gap);
    return watched(listener, [&](const Progress& progress) { return read(file, options, progress); });
  });
  module.def("simplify_contours", &simplified);
  module.def("together", &joined);
  module.def("sample", &sample);
  module.def("kind_of", [](const std::string& file) {
    const py::gil_scoped_release unlocked;
    return kind_of_file(file);
  });
}

}  // namespace odontoscope::python
