#include <pybind11/stl.h>

#include <array>
#include <string>
#include <utility>

#include "engine/app/volume_options.h"
#include "python/binding/arrays.h"
#include "python/binding/parts.h"
#include "python/binding/session.h"
#include "python/binding/watched.h"
#include "recon/volume/oriented_image.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/thresholds.h"

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
    return VolumeImage{std::make_shared<const Volume>(
        read_volume(file, {.spacing = spacing, .series = series, .allow_outside = allow_outside}, progress))};
  });
}

py::array values_of(const VolumeImage& image) {
  const Volume& volume = *image.volume;
  const auto step = static_cast<py::ssize_t>(sizeof(float));
  const auto columns = static_cast<py::ssize_t>(volume.size[0]), rows = static_cast<py::ssize_t>(volume.size[1]);
  return read_only(py::array(py::dtype::of<float>(), {static_cast<py::ssize_t>(volume.size[2]), rows, columns},
                             {rows * columns * step, columns * step, step}, volume.values.data(), kept(image.volume)));
}

app::VolumeWords volume_words(const py::dict& given) {
  app::VolumeWords words;
  words.isos = given["iso"].cast<std::vector<std::string>>();
  words.labels = given["label"].cast<std::vector<std::string>>();
  words.label_names = given["label_names"].cast<std::string>();
  words.min_area = given["min_area"].cast<std::string>();
  words.smooth = given["smooth"].cast<std::optional<double>>();
  words.simplify = given["simplify"].cast<std::optional<double>>();
  words.reshape.crop = given["crop"].cast<std::string>();
  words.reshape.resample = given["resample"].cast<std::optional<double>>();
  words.reshape.upright = given["upright"].cast<bool>();
  return words;
}

/// The image itself stays as it is.
Contours traced(const VolumeImage& image, const app::VolumeRequest& request, bool reshaped, app::Session& session) {
  Origin origin{image.volume, {}, {}, reshaped};
  VolumeContourOptions levels;
  std::optional<RigidMotion> upright;
  if (reshaped) {
    auto own = std::make_shared<Volume>(*image.volume);
    app::crop_told(*own, request.reshape, session.console);
    levels = app::levels_told(*own, request, session);
    upright = app::reshape_told(*own, request.reshape, levels, session);
    origin.volume = std::move(own);
  } else {
    levels = app::levels_told(*image.volume, request, session);
  }
  const Volume& volume = *origin.volume;
  origin.whence = {volume.patient, VoxelGrid{volume.size, volume.spacing, volume.origin}};
  Contours made;
  made.stack = std::make_shared<const ContourStack>(
      app::traced_told(volume, std::move(levels), request, upright, session, &origin.facts));
  made.remarks = volume.remarks;
  made.origin = std::make_shared<const Origin>(std::move(origin));
  return made;
}

Contours contours_of(const VolumeImage& image, const py::dict& given, const py::object& listener) {
  const app::VolumeWords words = volume_words(given);
  app::refuse_volume_without_level({}, words);
  const app::VolumeRequest request = app::understood(words);
  QuietSession session;
  Contours made = watched(listener, [&](const Progress& progress) {
    return traced(image, request, words.reshape.any(), session.watched_by(progress));
  });
  session.warn();
  return made;
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
