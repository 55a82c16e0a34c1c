#pragma once
// Models as files, with the options that `odontoscope reconstruct` has for them.

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "python/binding/parts.h"
#include "recon/formats/write_glb.h"

namespace odontoscope::python {

/// All or none. `given`: compress, see_through, variants (bool), voxels, voxel_origin ("X,Y,Z" or ""). `within`: tours
/// and hotspots, by whoever knows the way through the model. UsageError for options that are about none of the files.
void write(const Model& model, const std::vector<std::string>& files, const py::dict& given, const GlbOptions& within,
           const py::object& listener);

/// Names and contents, all or none.
void write_texts(const std::vector<std::pair<std::string, std::string>>& texts);

}  // namespace odontoscope::python
