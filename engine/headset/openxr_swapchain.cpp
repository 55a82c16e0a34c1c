#include "engine/headset/openxr_swapchain.h"

#include <algorithm>

#include "engine/headset/headset.h"
#include "engine/headset/openxr_graphics.h"

namespace odontoscope {

std::int64_t swapchain_format(XrSession session) {
  std::uint32_t count = 0;
  check(xrEnumerateSwapchainFormats(session, 0, &count, nullptr), "asking for formats of pictures");
  std::vector<std::int64_t> offered(count);
  check(xrEnumerateSwapchainFormats(session, count, &count, offered.data()), "asking for formats of pictures");
  // Our pictures are sRGB already; in any other format the runtime would take them for linear light.
  if (std::find(offered.begin(), offered.end(), GL_SRGB8_ALPHA8) != offered.end()) return GL_SRGB8_ALPHA8;
  throw HeadsetError("headset-graphics", "the OpenXR runtime takes no sRGB pictures of 8 bits from OpenGL", "Update the headset's software.");
}

EyePictures::EyePictures(const Gl& gl, XrSession session, std::int64_t format, PixelSize size) : gl_(&gl), size_(size) {
  XrSwapchainCreateInfo wanted{XR_TYPE_SWAPCHAIN_CREATE_INFO};
  wanted.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT;
  wanted.format = format;
  wanted.sampleCount = 1;
  wanted.width = static_cast<std::uint32_t>(size.width);
  wanted.height = static_cast<std::uint32_t>(size.height);
  wanted.faceCount = wanted.arraySize = wanted.mipCount = 1;
  check(xrCreateSwapchain(session, &wanted, swapchain_.fill()), "making the eyes' pictures");
  depth_ = make_texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, depth_.id());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size.width, size.height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  for (const unsigned image : images_of(swapchain_.get())) {
    framebuffers_.push_back(make_framebuffer(gl));
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_.back().id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw HeadsetError("headset-graphics", "the graphics driver cannot draw into the headset's pictures", "Update the graphics driver.");
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

Target EyePictures::acquire() {
  std::uint32_t index = 0;
  check(xrAcquireSwapchainImage(swapchain_.get(), nullptr, &index), "taking an eye's picture");
  XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
  wait.timeout = XR_INFINITE_DURATION;
  check(xrWaitSwapchainImage(swapchain_.get(), &wait), "waiting for an eye's picture");
  lent_ = true;   // one that was not waited for must not be given back
  return {framebuffers_.at(index).id(), 0, 0, size_, true};
}

void EyePictures::release() {
  if (!lent_) return;
  lent_ = false;
  check(xrReleaseSwapchainImage(swapchain_.get(), nullptr), "giving an eye's picture back");
}

XrSwapchainSubImage EyePictures::shown() const { return {swapchain_.get(), {{0, 0}, {size_.width, size_.height}}, 0}; }

}  // namespace odontoscope
