#include "python/binding/errors.h"

#include <exception>
#include <string>

#include "recon/core/error.h"

namespace odontoscope::python {
namespace {

namespace py = pybind11;

/// Nothing that is not known.
py::dict dict_of(const Place& place) {
  py::dict known;
  if (!place.file.empty()) known["file"] = place.file;
  if (place.slice) known["slice"] = *place.slice;
  if (place.z) known["z"] = *place.z;
  if (place.contour) known["contour"] = *place.contour;
  if (place.point) known["point"] = *place.point;
  if (place.at) known["at"] = py::make_tuple(place.at->x, place.at->y);
  if (place.line) known["line"] = *place.line;
  if (place.byte) known["byte"] = *place.byte;
  return known;
}

void raise(const char* type, const Error& error, const std::string& cause, const py::dict& place) {
  const py::object made = py::module_::import("odontoscope.errors")
                              .attr(type)(std::string(error.what()), cause, place, error.wrong(), error.remedy());
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise("InputError", error, error.cause(), dict_of(error.place()));
  } catch (const FileError& error) {
    Place place;
    place.file = error.file();
    raise("FileError", error, "", dict_of(place));
  } catch (const UsageError& error) {
    raise("UsageError", error, "", {});
  } catch (const InternalError& error) {
    raise("InternalError", error, "", {});
  }
}

}  // namespace

void raise_error(const char* type, const Error& error, const std::string& cause) { raise(type, error, cause, {}); }

void translate_errors() { py::register_exception_translator(&translate); }

}  // namespace odontoscope::python
