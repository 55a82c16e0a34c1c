#include "python/binding/errors.h"

#include <cctype>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

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

/// A message's two sentences: what is wrong, and what to do. The former is one clause (see error.h): it ends at the
/// first full stop that a capital letter follows.
std::pair<std::string, std::string> sentences(std::string_view text) {
  for (std::size_t stop = text.find(". "); stop != text.npos; stop = text.find(". ", stop + 1))
    if (std::isupper(static_cast<unsigned char>(text[stop + 2])) != 0)
      return {std::string(text.substr(0, stop)), std::string(text.substr(stop + 2))};
  return {std::string(text), {}};
}

void raise(const char* type, const Error& error, const std::string& cause, const py::dict& place,
           std::string_view told) {
  auto [wrong, remedy] = sentences(told);
  const py::object made =
      py::module_::import("odontoscope.errors").attr(type)(std::string(error.what()), cause, place, wrong, remedy);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
}

std::string_view without(std::string_view text, const std::string& before, const std::string& behind) {
  if (!before.empty() && text.starts_with(before)) text.remove_prefix(before.size());
  if (text.ends_with(behind)) text.remove_suffix(behind.size());
  return text;
}

void raise_file_error(const FileError& error) {
  const std::string_view told = error.what();
  const std::size_t colon = told.find(": ");
  Place place;
  if (colon != told.npos) place.file = told.substr(0, colon);
  raise("FileError", error, "", dict_of(place), colon == told.npos ? told : told.substr(colon + 2));
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    const std::string words = error.place().in_words();
    raise("InputError", error, error.cause(), dict_of(error.place()),
          without(error.what(), words.empty() ? words : words + ": ", " [" + error.cause() + "]"));
  } catch (const FileError& error) {
    raise_file_error(error);
  } catch (const UsageError& error) {
    raise("UsageError", error, "", {}, error.what());
  } catch (const InternalError& error) {
    raise("InternalError", error, "", {}, error.what());
  }
}

}  // namespace

void raise_error(const char* type, const Error& error, const std::string& cause) {
  raise(type, error, cause, {}, without(error.what(), {}, " [" + cause + "]"));
}

void translate_errors() { py::register_exception_translator(&translate); }

}  // namespace odontoscope::python
