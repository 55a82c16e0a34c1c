#pragma once
// Draws what ImGui made, through the same table of functions as everything else: so in a window, EGL and OSMesa alike.

#include "engine/gpu/program.h"
#include "engine/render/resolve_pass.h"
#include "engine/ui/interface.h"

namespace odontoscope {

class InterfacePass {
 public:
  InterfacePass(const Gl& gl, const ShaderLibrary& shaders);
  /// Over what `target` shows.
  void draw(const Interface& interface, const ImDrawData& drawn, const Target& target);

 private:
  void upload_letters(const Interface& interface);

  const Gl* gl_;
  Program program_;
  GlObject vertex_array_, vertices_, indices_, letters_;
  int font_version_ = 0;
};

}  // namespace odontoscope
