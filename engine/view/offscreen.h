#pragma once
// Pictures without a window.

#include "engine/gpu/context.h"
#include "engine/picture/image.h"
#include "engine/render/renderer.h"
#include "engine/scene/scene.h"

namespace odontoscope {

struct PictureOptions {
  PixelSize size{1200, 900};
  RenderOptions render;
};

/// What the scene's camera sees. The renderer's context is current. Throws GraphicsError.
Image picture_of(const Gl& gl, Renderer& renderer, const GpuModel& gpu_model, const Model& model, const Scene& scene,
                 const PictureOptions& options = {}, const GpuOverlay* overlay = nullptr,
                 const GpuValueGrid* values = nullptr, GpuVolume* volume = nullptr);

/// The same with everything made for one picture.
Image picture_of(GlContext& context, const Model& model, const Scene& scene, const PictureOptions& options = {});

/// The part of the framebuffer from its lower left corner, rows turned so that the first is the top one.
Image read_pixels(const Gl& gl, GLuint framebuffer, PixelSize size);

}  // namespace odontoscope
