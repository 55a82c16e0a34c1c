#pragma once
// Draws what ImGui made, through the same table of functions as everything else: so in a window, EGL and OSMesa alike.

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/gpu/program.h"
#include "engine/render/resolve_pass.h"
#include "engine/ui/interface.h"

namespace odontoscope {

/// Rows from the top.
struct GreyPicture {
  std::size_t width = 0, height = 0;
  std::span<const std::uint8_t> grey;
};

/// For ImGui's AddImage (its ImTextureID): the one grey picture among what is drawn.
void* grey_picture();

class InterfacePass {
 public:
  InterfacePass(const Gl& gl, const ShaderLibrary& shaders);
  /// Over what `target` shows. `picture`: what grey_picture() stands for in it.
  void draw(const Interface& interface, const ImDrawData& drawn, const Target& target,
            const GreyPicture* picture = nullptr);

 private:
  void upload_letters(const Interface& interface);
  void upload(const GreyPicture& picture);

  const Gl* gl_;
  Program program_;
  GlObject vertex_array_, vertices_, indices_, letters_, picture_;
  int font_version_ = 0;
};

}  // namespace odontoscope
