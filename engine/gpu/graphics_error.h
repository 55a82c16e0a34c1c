#pragma once

#include <string_view>

#include "recon/core/error.h"

namespace odontoscope {

/// No picture can be drawn on this machine: no display, no OpenGL, too old an OpenGL, no OSMesa. `cause` is one of
/// no-display, no-egl, no-osmesa, gl-too-old, no-gl, out-of-graphics-memory, picture-too-large.
class GraphicsError : public Error {
 public:
  GraphicsError(std::string_view cause, std::string_view wrong, std::string_view remedy);
  const std::string& cause() const { return cause_; }

 private:
  std::string cause_;
};

}  // namespace odontoscope
