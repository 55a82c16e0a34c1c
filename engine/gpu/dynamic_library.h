#pragma once
// A shared library that is opened when it is needed, so that a machine without it can still start the program.

#include <string>

namespace odontoscope {

class DynamicLibrary {
 public:
  /// Opens the first of `file_names` that exists; see `is_open`. Stays open for the life of the process: drivers keep
  /// threads and exit handlers that outlive every context.
  DynamicLibrary(std::initializer_list<const char*> file_names);

  bool is_open() const { return handle_ != nullptr; }
  /// Why it could not be opened.
  const std::string& trouble() const { return trouble_; }
  /// The function called `name`, null if there is none.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;
  void* handle_ = nullptr;
  std::string trouble_;
};

}  // namespace odontoscope
