#include <pybind11/stl.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/app/made_model.h"
#include "engine/app/sniff.h"
#include "python/binding/arrays.h"
#include "python/binding/parts.h"
#include "python/binding/watched.h"
#include "python/binding/writing.h"
#include "recon/cavity/anatomy.h"
#include "recon/compare/compare.h"
#include "recon/core/read_file.h"
#include "recon/delaunay/verdict.h"
#include "recon/input/links_json.h"
#include "recon/input/validate.h"
#include "recon/output/anatomy_text.h"
#include "recon/output/comparison_json.h"
#include "recon/output/comparison_page.h"
#include "recon/output/report_json.h"
#include "recon/partition/reconstruct_structures.h"

namespace odontoscope::python {
namespace {

/// Words of the program's options.
struct DtWords {
  std::string correspondence, between, links;  // links: the text of a links file, or empty
  int threads = 0;
};
struct PartitionWords {
  std::vector<std::string> priority;
  double gap = 0;
  int threads = 0;
};
struct DbWords {
  std::size_t columns = 0, rows = 0;
  std::vector<double> splits;
  std::string cases, field;
  std::optional<std::size_t> decimate;  // 0: as far as it goes
  int threads = 0;
};

template <class Choice>
Choice chosen(const std::string& word, const char* option, std::initializer_list<Choice> choices,
              const char* (*word_for)(Choice)) {
  std::string known;
  for (const Choice choice : choices) {
    if (word == word_for(choice)) return choice;
    known += (known.empty() ? "" : ", ") + std::string(word_for(choice));
  }
  throw UsageError(std::string(option) + "=\"" + word + "\" is none of its choices", "Say one of " + known);
}

const char* name_of(Between between) { return between == Between::blended ? "blended" : "delaunay"; }

ReconstructOptions understood(const DtWords& words, const ContourStack& stack) {
  ReconstructOptions options;
  options.correspondence = chosen(
      words.correspondence, "correspondence",
      {Correspondence::tracked, Correspondence::reverse, Correspondence::medial, Correspondence::overlap}, &name);
  options.between = chosen(words.between, "between", {Between::blended, Between::delaunay}, &name_of);
  options.threads = words.threads;
  if (words.links.empty()) return options;
  options.links = parse_links(words.links, "links");
  validate_links(options.links, ordered(stack).stack, "links");
  return options;
}

DbOptions understood(const DbWords& words) {
  DbOptions options;
  options.grid = {words.columns, words.rows, words.splits};
  options.cases =
      chosen(words.cases, "cases", {CaseTable::classic, CaseTable::classic_unoriented, CaseTable::consistent}, &name);
  options.field.kind =
      chosen(words.field, "field", {FieldKind::hybrid, FieldKind::signed_distance, FieldKind::sign}, &name);
  if (words.decimate)
    options.decimation =
        *words.decimate == 0 ? DecimateOptions{} : DecimateOptions{.triangles = words.decimate, .largest_error = 0};
  options.threads = words.threads;
  return options;
}

/// `triangles`: how many its surfaces may have together.
Model model_of(const Contours& contours, Reconstruction reconstruction, std::optional<std::size_t> triangles,
               const Progress& progress) {
  auto made = std::make_shared<DtModel>(DtModel{std::move(reconstruction), {}});
  if (triangles) made->simplification = simplify_surfaces(made->reconstruction, *triangles, progress);
  return {std::move(made), nullptr, contours.stack, contours.origin};
}

Model made_by_dt(const Contours& contours, const DtWords& words, std::optional<std::size_t> triangles,
                 const py::object& listener) {
  return watched(listener, [&](const Progress& progress) {
    return model_of(contours, reconstruct(*contours.stack, understood(words, *contours.stack), progress), triangles,
                    progress);
  });
}

/// A partition where structures share walls or overlap; why none came of it, if so.
std::pair<Model, std::string> made_of_structures(const Contours& contours, const DtWords& words,
                                                 std::optional<std::size_t> triangles, const py::object& listener) {
  std::string no_partition;
  Model model = watched(listener, [&](const Progress& progress) {
    MadeOfStructures made = reconstruct_structures(*contours.stack, understood(words, *contours.stack), progress);
    no_partition = std::move(made.no_partition);
    return model_of(contours, std::move(made.reconstruction), triangles, progress);
  });
  return {std::move(model), std::move(no_partition)};
}

Model made_as_partition(const Contours& contours, const PartitionWords& words, std::optional<std::size_t> triangles,
                        const py::object& listener) {
  PartitionOptions options;
  options.priority = words.priority;
  options.gap = words.gap;
  options.threads = words.threads;
  return watched(listener, [&](const Progress& progress) {
    return model_of(contours, reconstruct_partition(*contours.stack, options, progress), triangles, progress);
  });
}

/// A model of elements for simulation instead; the given one stays as it is.
Model meshed(const Model& model, std::optional<double> size, const py::object& listener) {
  return watched(listener, [&](const Progress& progress) {
    auto made = std::make_shared<DtModel>(*model.dt);
    made->elements = mesh_elements(made->reconstruction, size, progress);
    return Model{std::move(made), nullptr, model.contours, model.origin, model.dt};
  });
}

/// The model where the file of its volume has it, if that was stood upright; the given one stays as it is.
Model put_back(const Model& model, const py::object& listener) {
  if (!model.origin || !model.origin->facts || !model.origin->facts->upright) return model;
  return watched(listener, [&](const Progress&) {
    app::Model moved{model.dt->reconstruction, {}, {}, {}};
    app::move_model(moved, model.origin->facts->upright->inverse());
    auto made = std::make_shared<DtModel>(
        DtModel{std::move(moved.reconstruction), model.dt->simplification, model.dt->elements});
    auto origin = std::make_shared<Origin>(*model.origin);
    origin->facts->as_given = true;
    return Model{std::move(made), nullptr, model.contours, std::move(origin), model.exact};
  });
}

/// What `strict` lets not pass: the places of an amber verdict, and that fewer triangles could not be had.
std::vector<std::string> wanting_in(const Model& model) {
  std::vector<std::string> wanting;
  if (!model.dt) return wanting;
  for (const Attention& item : model.dt->reconstruction.attention) wanting.push_back(in_words(item));
  if (model.dt->simplification.aim && !model.dt->simplification.aim->reached())
    wanting.push_back(app::missed_aim_in_words(*model.dt->simplification.aim));
  return wanting;
}

std::optional<Complex> complex_of(const Model& model) {
  if (!model.dt || !model.dt->reconstruction.complex) return std::nullopt;
  return Complex{model.dt};
}

Model made_by_db(const Contours& contours, const DbWords& words, const py::object& listener) {
  const DbOptions options = understood(words);
  return watched(listener, [&](const Progress& progress) {
    return Model{
        nullptr,
        std::make_shared<DbModel>(DbModel{reconstruct_by_distance(*contours.stack, options, progress), options}),
        contours.stack, contours.origin};
  });
}

std::shared_ptr<Comparison> compared(const Contours& contours, const DtWords& dt, const DbWords& db,
                                     const py::object& listener) {
  CompareOptions options;
  options.db = understood(db);
  return watched(listener, [&](const Progress& progress) {
    options.dt = understood(dt, *contours.stack);
    return std::make_shared<Comparison>(compare(*contours.stack, options, progress));
  });
}

std::vector<Part> parts_of(const Model& model) {
  std::vector<Part> parts;
  if (model.dt)
    for (const Solid& solid : model.dt->reconstruction.solids)
      parts.push_back({model.dt, &solid.structure, &solid.surface, &solid.report, &solid.tetrahedra});
  if (model.db)
    for (const DbSurface& one : model.db->reconstruction.surfaces)
      parts.push_back({model.db, &one.structure, &one.surface, &one.report, nullptr});
  return parts;
}

std::string report_of(const Model& model) {
  const py::gil_scoped_release unlocked;
  if (model.db) return report_json(model.db->reconstruction, model.db->options);
  return report_json(model.dt->reconstruction, {.simplifications = model.dt->simplification.structures,
                                                .volume = model.origin ? model.origin->facts : std::nullopt,
                                                .aim = model.dt->simplification.aim,
                                                .elements = model.dt->elements});
}

std::string links_of(const Model& model) {
  std::vector<ReportedLink> links;
  if (model.dt)
    for (const MadeLink& made : model.dt->reconstruction.links) links.push_back({made.link, name(made.criterion)});
  return links_to_json(links);
}

/// JSON and CSV.
std::pair<std::string, std::string> anatomy_of(const Model& model, const std::string& source,
                                               const py::object& listener) {
  return watched(listener, [&](const Progress& progress) {
    std::vector<StructureSurface> sound;  // only what is closed has an inside
    for (const Part& part : parts_of(model))
      if (part.report->closed_oriented_manifold()) sound.push_back({*part.structure, part.surface});
    const std::size_t slices = model.dt ? model.dt->reconstruction.counts.slices : model.db->reconstruction.slices;
    const Anatomy anatomy = measure_anatomy(sound, progress, slices);
    return std::pair(anatomy_json(anatomy, source), anatomy_csv(anatomy));
  });
}

std::string inspected(const std::vector<NamedMesh>& meshes, const std::string& file) {
  const py::gil_scoped_release unlocked;
  std::vector<NamedSurfaceReport> reports;
  for (const NamedMesh& mesh : meshes) reports.push_back({mesh.name, inspect(mesh.surface)});
  return surface_report_json(file, reports);
}

std::vector<NamedMesh> meshes_of(const std::string& file) {
  const std::string bytes = read_file(file);
  const app::FileKind kind = app::kind_of(bytes, file);
  if (auto meshes = app::meshes_in(kind, bytes, file)) return std::move(*meshes);
  Place place;
  place.file = file;
  throw InputError("unknown-format", std::move(place), "this is no glTF, STL, PLY or OBJ mesh",
                   "Give a file of one of these formats");
}

using Points = py::array_t<double, py::array::c_style>;
using Corners = py::array_t<std::uint32_t, py::array::c_style>;  // (n, 3), each below the number of points: the package
                                                                 // has seen to that

std::string inspected_arrays(const Points& points, const Corners& triangles) {
  SurfaceMesh mesh;
  const auto p = points.unchecked<2>();
  for (py::ssize_t i = 0; i < points.shape(0); ++i) mesh.points.push_back({p(i, 0), p(i, 1), p(i, 2)});
  const auto t = triangles.unchecked<2>();
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i) mesh.triangles.push_back({t(i, 0), t(i, 1), t(i, 2)});
  return inspected({{"", std::move(mesh), {}}}, "");
}

/// Owner and views of a mesh that was read.
std::vector<Part> read_parts(const std::string& file) {
  struct Read {
    std::vector<NamedMesh> meshes;
    std::vector<SurfaceReport> reports;
  };
  const auto read = std::make_shared<Read>();
  const py::gil_scoped_release unlocked;
  read->meshes = meshes_of(file);
  for (const NamedMesh& mesh : read->meshes) read->reports.push_back(inspect(mesh.surface));
  std::vector<Part> parts;
  for (std::size_t i = 0; i < read->meshes.size(); ++i)
    parts.push_back({read, &read->meshes[i].name, &read->meshes[i].surface, &read->reports[i], nullptr});
  return parts;
}

double enclosed_by(const Part& part) {
  double volume = 0;
  for (const Shell& shell : part.report->shells) volume += shell.volume;
  return volume;
}

DtWords dt_words(const py::dict& given) {
  return {given["correspondence"].cast<std::string>(), given["between"].cast<std::string>(),
          given["links"].cast<std::string>(), given["threads"].cast<int>()};
}

DbWords db_words(const py::dict& given) {
  const auto grid = given["grid"].cast<std::pair<std::size_t, std::size_t>>();
  return {grid.first,
          grid.second,
          given["split"].cast<std::vector<double>>(),
          given["cases"].cast<std::string>(),
          given["field"].cast<std::string>(),
          given["decimate"].cast<std::optional<std::size_t>>(),
          given["threads"].cast<int>()};
}

void add_part(py::module_& module) {
  const auto optional = [](const Part& part, auto view) -> py::object {
    return part.tetrahedra != nullptr ? py::object(view(*part.tetrahedra)) : py::none();
  };
  py::class_<Part, std::shared_ptr<Part>>(module, "Part")
      .def("structure", [](const Part& part) { return *part.structure; })
      .def("points", [](const Part& part) { return table_view<double, 3>(part.surface->points, part.model); })
      .def("triangles", [](const Part& part) { return table_view<PointIndex, 3>(part.surface->triangles, part.model); })
      .def("tetrahedron_points",
           [optional](const Part& part) {
             return optional(part,
                             [&](const TetraMesh& mesh) { return table_view<double, 3>(mesh.points, part.model); });
           })
      .def("tetrahedra",
           [optional](const Part& part) {
             return optional(
                 part, [&](const TetraMesh& mesh) { return table_view<PointIndex, 4>(mesh.tetrahedra, part.model); });
           })
      .def("labels",
           [optional](const Part& part) {
             return optional(part, [&](const TetraMesh& mesh) { return list_view<Label>(mesh.labels, part.model); });
           })
      .def("volume", &enclosed_by)
      .def("closed", [](const Part& part) { return part.report->closed_oriented_manifold(); });
}

void add_complex(py::module_& module) {
  static_assert(std::is_standard_layout_v<InterfaceTriangle> &&
                offsetof(InterfaceTriangle, outer) == offsetof(InterfaceTriangle, inner) + sizeof(Label));
  py::class_<Complex, std::shared_ptr<Complex>>(module, "Complex")
      .def("structures", [](const Complex& self) { return self.get().structures; })
      .def("points", [](const Complex& self) { return table_view<double, 3>(self.get().mesh.points, self.model); })
      .def("tetrahedra",
           [](const Complex& self) { return table_view<PointIndex, 4>(self.get().mesh.tetrahedra, self.model); })
      .def("labels", [](const Complex& self) { return list_view<Label>(self.get().mesh.labels, self.model); })
      .def("interfaces",
           [](const Complex& self) {
             return member_view<PointIndex, 3>(self.get().interfaces, offsetof(InterfaceTriangle, triangle),
                                               self.model);
           })
      .def("interface_labels", [](const Complex& self) {
        return member_view<Label, 2>(self.get().interfaces, offsetof(InterfaceTriangle, inner), self.model);
      });
}

}  // namespace

void add_models(py::module_& module) {
  add_part(module);
  add_complex(module);
  py::class_<Model, std::shared_ptr<Model>>(module, "Model")
      .def("parts", &parts_of)
      .def("complex", &complex_of)
      .def("certified",
           [](const Model& model) {
             return model.dt ? model.dt->reconstruction.certified : model.db->reconstruction.certified;
           })
      .def("verdict",
           [](const Model& model) { return std::string(model.dt ? name(verdict_of(model.dt->reconstruction)) : ""); })
      .def("headline", [](const Model& model) { return model.dt ? headline(model.dt->reconstruction) : std::string(); })
      .def("report", &report_of)
      .def("links", &links_of)
      .def("wanting", &wanting_in)
      .def("write", &write)
      .def("anatomy", &anatomy_of);
  py::class_<GlbOptions>(module, "GltfExtras").def(py::init<>());
  py::class_<Comparison, std::shared_ptr<Comparison>>(module, "Comparison")
      .def("json", &comparison_json)
      .def("page", &comparison_page);
  module.def("by_dt",
             [](const Contours& contours, const py::dict& words, std::optional<std::size_t> triangles,
                const py::object& listener) { return made_by_dt(contours, dt_words(words), triangles, listener); });
  module.def("of_structures", [](const Contours& contours, const py::dict& words, std::optional<std::size_t> triangles,
                                 const py::object& listener) {
    return made_of_structures(contours, dt_words(words), triangles, listener);
  });
  module.def("as_partition", [](const Contours& contours, const std::vector<std::string>& priority, double gap,
                                int threads, std::optional<std::size_t> triangles, const py::object& listener) {
    return made_as_partition(contours, {priority, gap, threads}, triangles, listener);
  });
  module.def("meshed", &meshed);
  module.def("put_back", &put_back);
  module.def("write_texts", &write_texts);
  module.def("by_db", [](const Contours& contours, const py::dict& words, const py::object& listener) {
    return made_by_db(contours, db_words(words), listener);
  });
  module.def("compare",
             [](const Contours& contours, const py::dict& dt, const py::dict& db, const py::object& listener) {
               return compared(contours, dt_words(dt), db_words(db), listener);
             });
  module.def("check_file", [](const std::string& file) { return inspected(meshes_of(file), file); });
  module.def("check_arrays", &inspected_arrays);
  module.def("read_mesh", &read_parts);
}

}  // namespace odontoscope::python
