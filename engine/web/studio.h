#pragma once
// The studio: one page that makes models itself. It holds this engine as WebAssembly and the viewer's page
// (embedded_page), and works from disk like every page of ours.
//
// web/wasm/build makes it, with a compiler that this program's own build does without; where it lies ready when the
// program is built, it becomes part of it.

#include <string_view>

namespace odontoscope {

/// Empty if it was not there when this program was built.
std::string_view studio_page();

}  // namespace odontoscope
