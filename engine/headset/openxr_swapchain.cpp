#include "engine/headset/openxr_swapchain.h"

#include <algorithm>

#include "engine/headset/headset.h"
#include "engine/headset/openxr_graphics.h"

namespace odontoscope {

SwapchainFormats swapchain_formats(XrSession session, bool with_depth) {
  std::uint32_t count = 0;
  check(xrEnumerateSwapchainFormats(session, 0, &count, nullptr), "asking for formats of pictures");
  std::vector<std::int64_t> offered(count);
  check(xrEnumerateSwapchainFormats(session, count, &count, offered.data()), "asking for formats of pictures");
  const auto is_offered = [&](std::int64_t format) {
    return std::find(offered.begin(), offered.end(), format) != offered.end();
  };
  // Our pictures are sRGB already; in any other format the runtime would take them for linear light.
  if (!is_offered(GL_SRGB8_ALPHA8))
    throw HeadsetError("headset-graphics", "the OpenXR runtime takes no sRGB pictures of 8 bits from OpenGL",
                       "Update the headset's software.");
  SwapchainFormats formats{GL_SRGB8_ALPHA8, 0};
  if (with_depth)  // the last one is the finest
    for (const std::int64_t format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F})
      if (is_offered(format)) formats.depth = format;
  return formats;
}

Swapchain::Swapchain(XrSession session, std::int64_t format, PixelSize size, XrSwapchainUsageFlags usage)
    : size_(size) {
  XrSwapchainCreateInfo wanted{XR_TYPE_SWAPCHAIN_CREATE_INFO};
  wanted.usageFlags = usage;
  wanted.format = format;
  wanted.sampleCount = 1;
  wanted.width = static_cast<std::uint32_t>(size.width);
  wanted.height = static_cast<std::uint32_t>(size.height);
  wanted.faceCount = wanted.arraySize = wanted.mipCount = 1;
  check(xrCreateSwapchain(session, &wanted, swapchain_.fill()), "making the eyes' pictures");
  images_ = images_of(swapchain_.get());
}

std::size_t Swapchain::acquire() {
  std::uint32_t index = 0;
  check(xrAcquireSwapchainImage(swapchain_.get(), nullptr, &index), "taking an eye's picture");
  XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
  wait.timeout = XR_INFINITE_DURATION;
  check(xrWaitSwapchainImage(swapchain_.get(), &wait), "waiting for an eye's picture");
  lent_ = true;  // one that was not waited for must not be given back
  return index;
}

void Swapchain::release() {
  if (!lent_) return;
  lent_ = false;
  check(xrReleaseSwapchainImage(swapchain_.get(), nullptr), "giving an eye's picture back");
}

EyePictures::EyePictures(const Gl& gl, XrSession session, const SwapchainFormats& formats, PixelSize size)
    : gl_(&gl),
      size_(size),
      colours_(session, formats.colour, size,
               XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT |
                   XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT) {
  if (formats.depth != 0) {
    depths_.emplace(session, formats.depth, size,
                    XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT);
  } else {
    own_depth_ = make_texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, own_depth_.id());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size.width, size.height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                  nullptr);
  }
  for (const unsigned image : colours_.images()) {
    framebuffers_.push_back(make_framebuffer(gl));
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_.back().id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                            depths_ ? depths_->images().front() : own_depth_.id(), 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw HeadsetError("headset-graphics", "the graphics driver cannot draw into the headset's pictures",
                         "Update the graphics driver.");
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

Target EyePictures::acquire() {
  const GLuint framebuffer = framebuffers_.at(colours_.acquire()).id();
  if (depths_) {
    // Colours and depths take turns each in their own way.
    const unsigned image = depths_->images().at(depths_->acquire());
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, image, 0);
  }
  return {framebuffer, 0, 0, size_, true, true};
}

void EyePictures::release() {
  colours_.release();
  if (depths_) depths_->release();
}

}  // namespace odontoscope
