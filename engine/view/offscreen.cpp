#include "engine/view/offscreen.h"

#include <algorithm>

namespace odontoscope {

Image read_pixels(const Gl& gl, GLuint framebuffer, PixelSize size) {
  Image upside_down(size.width, size.height);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.rgba.data());
  Image image(size.width, size.height);
  const auto row = 4 * static_cast<std::ptrdiff_t>(size.width);
  for (std::ptrdiff_t y = 0; y < size.height; ++y)
    std::copy_n(upside_down.rgba.begin() + (size.height - 1 - y) * row, row, image.rgba.begin() + y * row);
  return image;
}

Image picture_of(const Gl& gl, Renderer& renderer, const GpuModel& gpu_model, const Model& model, const Scene& scene,
                 const PictureOptions& options, const GpuOverlay* overlay, const GpuValueGrid* values,
                 GpuVolume* volume) {
  const Framebuffer pixels(gl, {options.size, {GL_RGBA8}, GL_DEPTH_COMPONENT32F});
  const double aspect = static_cast<double>(options.size.width) / options.size.height;
  const Pane pane{view_of(scene.camera, model, aspect), {pixels.id(), 0, 0, options.size, true}};
  renderer.draw(gpu_model, scene, {&pane, 1}, options.render, overlay, values, volume);
  return read_pixels(gl, pixels.id(), options.size);
}

Image picture_of(GlContext& context, const Model& model, const Scene& scene, const PictureOptions& options) {
  context.make_current();
  Renderer renderer(context.gl(), shaders_from_environment());
  const GpuModel gpu_model = upload(context.gl(), model);
  return picture_of(context.gl(), renderer, gpu_model, model, scene, options);
}

}  // namespace odontoscope
