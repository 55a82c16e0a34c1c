#include "engine/gpu/dynamic_library.h"

#include "recon/core/system_processes.h"

namespace odontoscope {

DynamicLibrary::DynamicLibrary(std::initializer_list<const char*> file_names) {
  for (const char* file_name : file_names) {
    std::string trouble;
    handle_ = system::open_library(file_name, trouble);
    if (handle_ != nullptr) return;
    if (trouble_.empty()) trouble_ = trouble;
  }
}

void* DynamicLibrary::symbol(const char* name) const {
  return handle_ != nullptr ? system::symbol(handle_, name) : nullptr;
}

}  // namespace odontoscope
