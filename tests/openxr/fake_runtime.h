#pragma once
// An OpenXR runtime that does what a test says, and keeps a record of what it was asked for. The loader opens it as it
// opens any other, so that the program under test is the one that people run. It draws nothing and tracks nothing:
// tests/xr has a real one.

#include <openxr/openxr.h>

#include <map>
#include <string>
#include <vector>

#include "engine/gpu/gl.h"

namespace odontoscope::testing_support {

/// One end of a frame.
struct FakeFrame {
  bool asked_for = false;  // shouldRender
  int views = 0;           // of its projection layer; 0: nothing was shown
  struct Depth {
    float low = 0, high = 0, near_z = 0, far_z = 0;
    XrSwapchain swapchain = XR_NULL_HANDLE;
    int image = -1;  // that was released last
  };
  std::vector<Depth> depths;  // of the views that had one
  std::vector<int> images;    // released last, a view
};

struct FakeSwapchain {
  XrSwapchainCreateInfo info{};
  std::vector<GLuint> images;
  int next = 0, released = -1;
  bool acquired = false, waited = false, destroyed = false;
};

struct FakeRuntime {
  // The test's part. `gl` makes the pictures; everything else may change at any time.
  const Gl* gl = nullptr;
  std::vector<std::string> extensions = {"XR_KHR_opengl_enable", "XR_MNDX_egl_enable"};
  std::vector<std::int64_t> formats = {GL_RGBA16F, GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT32F};
  std::uint32_t side = 64;  // pixels of an eye's picture
  bool should_render = true, eyes_known = true;
  bool hands_held = true;  // controllers are there; false: put away
  float trigger = 0;       // of both
  bool obliging = false;  // leads a session to the focus when it is opened, and to its end when asked to; otherwise the
                          // test tells states
  XrPosef head{{0, 0, 0, 1}, {0, 1.6f, 0}};
  std::vector<XrVector2f> hidden_corners;   // of the mask of what lenses hide, as triangles; tangents
  std::map<std::string, XrResult> answers;  // instead of doing anything, by the function's name

  /// What the program is told at its next xrPollEvent.
  void tell(XrSessionState state);
  void tell_lost_instance();
  /// The person chose a new middle for the room.
  void tell_recentred(XrReferenceSpaceType type = XR_REFERENCE_SPACE_TYPE_LOCAL);

  // The record.
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;  // as told
  bool running = false, exit_requested = false;
  int waited = 0, begun = 0, sessions = 0, instances = 0;  // the last two: that live
  std::vector<FakeFrame> ended;
  std::vector<FakeSwapchain> swapchains;
  std::vector<std::string> enabled;  // extensions
  std::vector<std::string> misuse;   // calls that the specification forbids
  XrTime time = 1'000'000'000;       // of the last beat

  std::vector<XrEventDataBuffer> events;
};

/// Makes the loader use the fake from now on in this process, as new. Valid until the process ends.
FakeRuntime& use_fake_runtime();

}  // namespace odontoscope::testing_support
