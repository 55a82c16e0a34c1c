// In place of engine/app/comparison_drawn.cpp: there is no OpenGL here.
#include "engine/app/comparison_drawn.h"

namespace odontoscope::app {

std::string add_comparison_pictures(Comparison&, Session&) { return "the program as WebAssembly does not draw"; }

}  // namespace odontoscope::app
