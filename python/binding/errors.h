#pragma once
// Errors of recon/core/error.h as the exceptions of odontoscope/errors.py.

#include <pybind11/pybind11.h>

namespace odontoscope::python {

/// Every function of `module` that throws an Error raises its counterpart from then on.
void translate_errors();

}  // namespace odontoscope::python
