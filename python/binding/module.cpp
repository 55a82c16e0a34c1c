// The part of the Python package that is compiled. python/odontoscope/__init__.py is what users see; it checks types
// and words.

#include "python/binding/errors.h"
#include "python/binding/parts.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The library of Odontoscope; use the package odontoscope instead.";
  module.attr("__version__") = ODONTOSCOPE_PYTHON_VERSION;
  odontoscope::python::translate_errors();
  odontoscope::python::add_contours(module);
  odontoscope::python::add_volumes(module);
  odontoscope::python::add_models(module);
}
