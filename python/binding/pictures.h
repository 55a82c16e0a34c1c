#pragma once
// What `odontoscope render` draws, of values that Python holds.

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <variant>

#include "python/binding/parts.h"
#include "recon/formats/write_glb.h"

namespace odontoscope::python {

/// A model; an image of which the grey values alone are seen; the file of a mesh.
using Seen = std::variant<Model, VolumeImage, std::string>;

/// Throws what `pictures` would throw whatever is seen.
void refuse_senseless_pictures(const py::dict& words);

/// A list of arrays (rows, columns, 4), the caller's own: one, or of a turntable or tour as many as were asked for.
/// `words` as draw.words makes them.
py::list pictures(const Seen& seen, const py::dict& words, const py::object& listener);

/// A tour as a film, .mp4 or .webm, written whole or not at all; how long it lasts, seconds. `words` as for a tour;
/// frames 0: 30 a second.
double film(const Seen& seen, const std::string& file, const py::dict& words, const py::object& listener);

/// Canals and structures of a mesh file in numbers: JSON and CSV.
std::pair<std::string, std::string> anatomy_of_mesh(const std::string& file, const py::object& listener);

/// Cameras and places with names for .glb and .gltf.
GlbOptions gltf_extras(const Model& model, bool tours, bool hotspots, const py::object& listener);

}  // namespace odontoscope::python
