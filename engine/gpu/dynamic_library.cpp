#include "engine/gpu/dynamic_library.h"

#include <dlfcn.h>

namespace odontoscope {

DynamicLibrary::DynamicLibrary(std::initializer_list<const char*> file_names) {
  for (const char* file_name : file_names) {
    handle_ = dlopen(file_name, RTLD_NOW | RTLD_LOCAL);
    if (handle_) return;
    if (trouble_.empty()) trouble_ = dlerror();
  }
}

void* DynamicLibrary::symbol(const char* name) const { return handle_ ? dlsym(handle_, name) : nullptr; }

}  // namespace odontoscope
