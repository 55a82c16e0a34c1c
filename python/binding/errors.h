#pragma once
// Errors of recon/core/error.h as the exceptions of odontoscope/errors.py.

#include <pybind11/pybind11.h>

#include <string>

#include "recon/core/error.h"

namespace odontoscope::python {

/// Every function of `module` that throws an Error raises its counterpart from then on.
void translate_errors();

/// Sets Python's error, for translators of errors that only some modules know: `type` is a class of
/// odontoscope/errors.py.
void raise_error(const char* type, const Error& error, const std::string& cause);

}  // namespace odontoscope::python
