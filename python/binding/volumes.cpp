#include <pybind11/stl.h>

#include <array>
#include <string>
#include <utility>

#include "python/binding/arrays.h"
#include "python/binding/parts.h"
#include "python/binding/watched.h"
#include "recon/volume/oriented_image.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/thresholds.h"
#include "recon/volume/volume_contours.h"

namespace odontoscope::python {
namespace {

using Voxels = py::array_t<float, py::array::c_style>;  // (slices, rows, columns): the package has seen to that

/// `direction[n]` is the unit vector along which axis n of the image runs, x first.
VolumeImage volume_of(const Voxels& voxels, const Vector3& spacing, const Vector3& origin,
                      const std::array<Vector3, 3>& direction, const std::string& source, const py::object& listener) {
  FileImage image;
  for (std::size_t axis = 0; axis < 3; ++axis)
    image.size[axis] = static_cast<std::size_t>(voxels.shape(static_cast<py::ssize_t>(2 - axis)));
  image.spacing = spacing;
  image.origin = origin;
  image.direction = direction;
  image.source = source;
  image.values.assign(voxels.data(), voxels.data() + voxels.size());
  return watched(listener, [&](const Progress&) {
    oriented_grid(image);  // before anything is moved
    Volume volume = oriented(std::move(image));
    validate_volume(volume);
    return VolumeImage{std::make_shared<const Volume>(std::move(volume))};
  });
}

VolumeImage read_image(const std::string& file, std::optional<Vector3> spacing, const std::string& series,
                       bool allow_outside, const py::object& listener) {
  return watched(listener, [&](const Progress& progress) {
    return VolumeImage{std::make_shared<const Volume>(read_volume(file, {spacing, series, allow_outside}, progress))};
  });
}

py::array values_of(const VolumeImage& image) {
  const Volume& volume = *image.volume;
  const auto step = static_cast<py::ssize_t>(sizeof(float));
  const auto columns = static_cast<py::ssize_t>(volume.size[0]), rows = static_cast<py::ssize_t>(volume.size[1]);
  return read_only(py::array(py::dtype::of<float>(), {static_cast<py::ssize_t>(volume.size[2]), rows, columns},
                             {rows * columns * step, columns * step, step}, volume.values.data(), kept(image.volume)));
}

using Isos = std::vector<std::pair<double, std::string>>;
using Labels = std::vector<std::pair<std::int64_t, std::string>>;

Contours contours_of(const VolumeImage& image, const Isos& isos, const Labels& labels, double min_area,
                     std::optional<double> smooth, std::optional<double> simplify, const py::object& listener) {
  VolumeContourOptions options;
  for (const auto& [threshold, structure] : isos) options.isos.push_back({threshold, structure});
  for (const auto& [label, structure] : labels) options.labels.push_back({label, structure});
  options.trace.min_area = min_area;
  if (smooth) options.smooth = SmoothLabelsOptions{*smooth};
  if (simplify) options.simplify = SimplifyContoursOptions{*simplify};
  return watched(listener, [&](const Progress& progress) {
    return Contours{std::make_shared<const ContourStack>(contours_of_volume(*image.volume, options, progress).stack),
                    {},
                    image.volume->remarks};
  });
}

std::vector<double> thresholds_of(const VolumeImage& image, std::size_t classes) {
  const py::gil_scoped_release unlocked;
  return otsu_thresholds(histogram_of(*image.volume, validate_volume(*image.volume)), classes);
}

std::vector<std::pair<std::int64_t, std::string>> names_of(const VolumeImage& image) {
  std::vector<std::pair<std::int64_t, std::string>> names;
  for (const VolumeLabel& label : image.volume->labels) names.emplace_back(label.value, label.name);
  return names;
}

}  // namespace

void add_volumes(py::module_& module) {
  py::class_<VolumeImage, std::shared_ptr<VolumeImage>>(module, "Volume")
      .def("values", &values_of)
      .def("spacing", [](const VolumeImage& self) { return self.volume->spacing; })
      .def("origin",
           [](const VolumeImage& self) {
             return std::array<double, 3>{self.volume->origin.x, self.volume->origin.y, self.volume->origin.z};
           })
      .def("source", [](const VolumeImage& self) { return self.volume->source; })
      .def("remarks", [](const VolumeImage& self) { return self.volume->remarks; })
      .def("tilt_degrees", [](const VolumeImage& self) { return self.volume->tilt_degrees; })
      .def("names", &names_of)
      .def("contours", &contours_of)
      .def("thresholds", &thresholds_of);
  module.def("volume", &volume_of);
  module.def("read_volume", &read_image);
}

}  // namespace odontoscope::python
