#pragma once
// What the module is made of, and the values that Python holds.

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/app/structure_files.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/input/contour_stack.h"
#include "recon/output/element_model.h"
#include "recon/output/report_json.h"
#include "recon/output/simplify_model.h"
#include "recon/volume/volume.h"

namespace odontoscope::python {

namespace py = pybind11;

/// What is known of the file or image that contours came from.
struct Origin {
  std::shared_ptr<const Volume> volume;  // as it was traced; null: no volume
  std::optional<ReportVolume> facts;
  app::Whence whence;
  bool reshaped = false;  // cropped, resampled or turned
};

/// A valid stack that nobody changes any more: views of its points stay true.
struct Contours {
  std::shared_ptr<const ContourStack> stack;
  std::vector<std::string> changes, remarks;  // by repair; by the file's reader
  std::shared_ptr<const Origin> origin;       // null: nothing is known
};

/// What DT made.
struct DtModel {
  Reconstruction reconstruction;
  ModelSimplification simplification;
  std::optional<ModelElements> elements = {};
};

/// What DB made.
struct DbModel {
  DbReconstruction reconstruction;
  DbOptions options;
};

/// Either; never changed.
struct Model {
  std::shared_ptr<const DtModel> dt;
  std::shared_ptr<const DbModel> db;
  std::shared_ptr<const ContourStack> contours;  // that it was made from
  std::shared_ptr<const Origin> origin;          // of these; null: nothing is known
  std::shared_ptr<const DtModel> exact = {};     // before it was meshed anew for simulation; null: it was not
};

/// One structure of a model.
struct Part {
  std::shared_ptr<const void> model;
  const std::string* structure = nullptr;
  const SurfaceMesh* surface = nullptr;
  const SurfaceReport* report = nullptr;
  const TetraMesh* tetrahedra = nullptr;  // null: DB has none
};

/// What the structures of a partition share.
struct Complex {
  std::shared_ptr<const DtModel> model;
  const LabelledComplex& get() const { return *model->reconstruction.complex; }
};

struct VolumeImage {
  std::shared_ptr<const Volume> volume;
};

void add_contours(py::module_& module);
void add_volumes(py::module_& module);
void add_models(py::module_& module);

}  // namespace odontoscope::python
