#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>

#include "tests/openxr/fake_runtime.h"

namespace odontoscope::testing_support {

FakeRuntime& use_fake_runtime() {
  setenv("XR_RUNTIME_JSON", ODONTOSCOPE_FAKE_MANIFEST, 1);
  // The loader opens the same file, and so the same state.
  void* library = dlopen(ODONTOSCOPE_FAKE_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  auto* runtime = reinterpret_cast<FakeRuntime* (*)()>(dlsym(library, "odontoscope_fake_runtime"))();
  *runtime = {};
  return *runtime;
}

}  // namespace odontoscope::testing_support
