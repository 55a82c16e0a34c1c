#pragma once
// OpenGL 4.1 core as a value: the table of functions of one context. Every object here keeps a pointer to the table of
// the context that it was made in, and that context must be current whenever the object is used or destroyed.

#include <glad/gl.h>

namespace odontoscope {

using Gl = GladGLContext;

}  // namespace odontoscope
