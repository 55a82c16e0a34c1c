#include <fmt/format.h>
#include <openxr/openxr.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/headset/headset.h"
#include "engine/headset/openxr_actions.h"
#include "engine/headset/openxr_calls.h"
#include "engine/headset/openxr_graphics.h"
#include "engine/headset/openxr_swapchain.h"

namespace odontoscope {

namespace {

constexpr XrViewConfigurationType two_eyes = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
constexpr const char* program = "Odontoscope";

/// What is used where the runtime has it.
struct Extras {
  bool depth = false, mask = false;
};

Extras create_instance(OwnedInstance& instance, const CurrentGraphics& graphics, const HeadsetOptions& options) {
  std::uint32_t count = 0;
  check(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr), "asking what the runtime can do");
  std::vector<XrExtensionProperties> known(count, {XR_TYPE_EXTENSION_PROPERTIES});
  check(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, known.data()), "asking what the runtime can do");
  const auto is_known = [&](const char* extension) {
    return std::any_of(known.begin(), known.end(), [&](const XrExtensionProperties& one) {
      return std::strcmp(one.extensionName, extension) == 0;
    });
  };
  std::vector<const char*> wanted = graphics.extensions();
  for (const char* extension : wanted) {
    if (!is_known(extension))
      throw HeadsetError(
          "headset-graphics",
          fmt::format("the OpenXR runtime takes no pictures from OpenGL through {} (it lacks {})", graphics.words(),
                      extension),
          "Use a runtime that does: SteamVR, Monado or WiVRn, with the viewer on an X display or XWayland.");
  }
  const Extras extras{is_known(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME),
                      is_known(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME)};
  if (extras.depth) wanted.push_back(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME);
  if (extras.mask) wanted.push_back(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME);
  std::vector<const char*> layers;
  for (const std::string& layer : options.layers) layers.push_back(layer.c_str());
  XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
  std::strncpy(info.applicationInfo.applicationName, program, XR_MAX_APPLICATION_NAME_SIZE - 1);
  std::strncpy(info.applicationInfo.engineName, program, XR_MAX_ENGINE_NAME_SIZE - 1);
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<std::uint32_t>(wanted.size());
  info.enabledExtensionNames = wanted.data();
  info.enabledApiLayerCount = static_cast<std::uint32_t>(layers.size());
  info.enabledApiLayerNames = layers.data();
  const XrResult result = xrCreateInstance(&info, instance.fill());
  if (result == XR_ERROR_RUNTIME_FAILURE)
    throw HeadsetError("openxr-service-absent",
                       fmt::format("an OpenXR runtime is installed and does not answer: {}", words_of(result)),
                       "Start it (SteamVR, or monado-service) with the headset connected, then try again.");
  check(result, "starting");
  return extras;
}

/// What the lenses of an eye hide; nothing if the runtime has nothing to say.
HiddenCorners hidden_corners(XrInstance instance, XrSession session, std::uint32_t eye) {
  PFN_xrVoidFunction function = nullptr;
  check(xrGetInstanceProcAddr(instance, "xrGetVisibilityMaskKHR", &function), "asking what the lenses hide");
  const auto get = reinterpret_cast<PFN_xrGetVisibilityMaskKHR>(function);
  const char* what = "asking what the lenses hide";
  XrVisibilityMaskKHR mask{XR_TYPE_VISIBILITY_MASK_KHR};
  check(get(session, two_eyes, eye, XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask), what);
  std::vector<XrVector2f> places(mask.vertexCountOutput);
  std::vector<std::uint32_t> indices(mask.indexCountOutput);
  if (places.empty() || indices.empty()) return {};
  mask.vertexCapacityInput = mask.vertexCountOutput;
  mask.indexCapacityInput = mask.indexCountOutput;
  mask.vertices = places.data();
  mask.indices = indices.data();
  check(get(session, two_eyes, eye, XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask), what);
  HiddenCorners corners;
  for (const std::uint32_t index : indices)
    if (index < places.size()) corners.emplace_back(places[index].x, places[index].y);
  corners.resize(corners.size() / 3 * 3);
  return corners;
}

/// One of `wanted` that the runtime has, the first of its own otherwise.
XrEnvironmentBlendMode blend_mode(XrInstance instance, XrSystemId system) {
  std::uint32_t count = 0;
  check(xrEnumerateEnvironmentBlendModes(instance, system, two_eyes, 0, &count, nullptr),
        "asking how pictures are mixed");
  std::vector<XrEnvironmentBlendMode> modes(count);
  check(xrEnumerateEnvironmentBlendModes(instance, system, two_eyes, count, &count, modes.data()),
        "asking how pictures are mixed");
  if (std::find(modes.begin(), modes.end(), XR_ENVIRONMENT_BLEND_MODE_OPAQUE) != modes.end())
    return XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  return modes.at(0);
}

class OpenXrHeadset final : public Headset {
 public:
  OpenXrHeadset(const Gl& gl, const HeadsetOptions& options) {
    const CurrentGraphics graphics;
    extras_ = create_instance(instance_, graphics, options);
    find_system(gl);
    XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, graphics.binding(), 0, system_};
    check(xrCreateSession(instance_.get(), &info, session_.fill()), "opening a session");
    create_space(XR_REFERENCE_SPACE_TYPE_LOCAL, room_);
    create_space(XR_REFERENCE_SPACE_TYPE_VIEW, head_);
    actions_ = std::make_unique<HandActions>(instance_.get(), session_.get());
    const PixelSize size = create_pictures(gl, options.resolution);
    ask_what_is_hidden();
    describe(graphics, size);
  }

  HeadsetState poll() override {
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    for (;;) {
      event = {XR_TYPE_EVENT_DATA_BUFFER};
      const XrResult result = xrPollEvent(instance_.get(), &event);
      check(result, "listening to it");
      if (result == XR_EVENT_UNAVAILABLE) return state();
      take(event);
    }
  }

  void frame(const Draw& draw) override {
    XrFrameState beat{XR_TYPE_FRAME_STATE};
    check(xrWaitFrame(session_.get(), nullptr, &beat), "waiting for its beat");
    const XrResult begun = xrBeginFrame(session_.get(), nullptr);
    check(begun, "beginning a frame");
    if (begun == XR_FRAME_DISCARDED) throw InternalError("a frame of the headset was begun and never ended");
    Shown shown;
    try {
      shown = drawn(beat, draw);
    } catch (...) {
      // A frame that was begun is ended, with nothing to show. What that says is of no interest now.
      for (EyePictures& eye : pictures_) quietly_release(eye);
      end_frame(beat.predictedDisplayTime, {});
      throw;
    }
    check(end_frame(beat.predictedDisplayTime, shown), "ending a frame");
  }

  void leave() override {
    if (begun_)
      check(xrRequestExitSession(session_.get()), "asking it to end");
    else
      over_ = true;
  }

  void pulse(std::size_t hand, double strength, double seconds) override { actions_->pulse(hand, strength, seconds); }

  const std::string& in_words() const override { return in_words_; }
  std::string controllers() const override { return actions_->controllers(); }

 private:
  void find_system(const Gl& gl) {
    XrSystemGetInfo wanted{XR_TYPE_SYSTEM_GET_INFO};
    wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    check(xrGetSystem(instance_.get(), &wanted, &system_), "looking for a headset");
    GLint major = 0, minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    check_requirements(instance_.get(), system_, major, minor);
    blend_ = blend_mode(instance_.get(), system_);
  }

  void create_space(XrReferenceSpaceType type, OwnedSpace& space) {
    XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO};
    info.referenceSpaceType = type;
    info.poseInReferenceSpace.orientation.w = 1;
    check(xrCreateReferenceSpace(session_.get(), &info, space.fill()), "measuring the room");
  }

  PixelSize create_pictures(const Gl& gl, double resolution) {
    std::uint32_t count = 0;
    check(xrEnumerateViewConfigurationViews(instance_.get(), system_, two_eyes, 0, &count, nullptr),
          "asking for its eyes");
    std::vector<XrViewConfigurationView> eyes(count, {XR_TYPE_VIEW_CONFIGURATION_VIEW});
    check(xrEnumerateViewConfigurationViews(instance_.get(), system_, two_eyes, count, &count, eyes.data()),
          "asking for its eyes");
    const SwapchainFormats formats = swapchain_formats(session_.get(), extras_.depth);
    PixelSize size;
    for (const XrViewConfigurationView& eye : eyes) {
      const auto pixels = [&](std::uint32_t recommended, std::uint32_t most) {
        return std::clamp(static_cast<int>(std::lround(resolution * recommended)), 16, static_cast<int>(most));
      };
      size = {pixels(eye.recommendedImageRectWidth, eye.maxImageRectWidth),
              pixels(eye.recommendedImageRectHeight, eye.maxImageRectHeight)};
      pictures_.emplace_back(gl, session_.get(), formats, size);
    }
    return size;
  }

  void ask_what_is_hidden() {
    if (!extras_.mask) return;
    hidden_.resize(pictures_.size());
    for (std::size_t eye = 0; eye < hidden_.size(); ++eye)
      hidden_[eye] = hidden_corners(instance_.get(), session_.get(), static_cast<std::uint32_t>(eye));
  }

  void describe(const CurrentGraphics& graphics, PixelSize size) {
    XrInstanceProperties runtime{XR_TYPE_INSTANCE_PROPERTIES};
    check(xrGetInstanceProperties(instance_.get(), &runtime), "asking for its name");
    XrSystemProperties system{XR_TYPE_SYSTEM_PROPERTIES};
    check(xrGetSystemProperties(instance_.get(), system_, &system), "asking for its name");
    in_words_ = fmt::format("{} {}.{}.{}, {}, {} x {} pixels an eye, through {}", runtime.runtimeName,
                            XR_VERSION_MAJOR(runtime.runtimeVersion), XR_VERSION_MINOR(runtime.runtimeVersion),
                            XR_VERSION_PATCH(runtime.runtimeVersion), system.systemName, size.width, size.height,
                            graphics.words());
  }

  HeadsetState state() const {
    if (over_) return HeadsetState::over;
    if (!begun_) return HeadsetState::waiting;
    if (session_state_ == XR_SESSION_STATE_FOCUSED) return HeadsetState::focused;
    return session_state_ == XR_SESSION_STATE_VISIBLE ? HeadsetState::visible : HeadsetState::running;
  }

  void take(const XrEventDataBuffer& event) {
    switch (event.type) {
      case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
        check(XR_ERROR_INSTANCE_LOST, "listening to it");
        break;
      case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED:
        go_on(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state);
        break;
      case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING: {
        const auto& change = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
        if (change.referenceSpaceType == XR_REFERENCE_SPACE_TYPE_LOCAL) recentred_at_ = change.changeTime;
        break;
      }
      case XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR:
        ask_what_is_hidden();
        break;
      default:
        break;
    }
  }

  void go_on(XrSessionState state) {
    session_state_ = state;
    if (state == XR_SESSION_STATE_READY) {
      XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO};
      info.primaryViewConfigurationType = two_eyes;
      check(xrBeginSession(session_.get(), &info), "beginning the session");
      begun_ = true;
    } else if (state == XR_SESSION_STATE_STOPPING) {
      begun_ = false;
      check(xrEndSession(session_.get()), "ending the session");
    } else if (state == XR_SESSION_STATE_EXITING) {
      over_ = true;
    } else if (state == XR_SESSION_STATE_LOSS_PENDING) {
      check(XR_ERROR_SESSION_LOST, "listening to it");
    }
  }

  /// An eye each; `depths` may be fewer.
  struct Shown {
    std::vector<XrCompositionLayerProjectionView> views;
    std::vector<XrCompositionLayerDepthInfoKHR> depths;
  };

  /// Draws, if it will be seen; what is to be shown of it, nothing otherwise.
  Shown drawn(const XrFrameState& beat, const Draw& draw) {
    HeadsetFrame frame;
    const XrTime time = beat.predictedDisplayTime;
    constexpr double longest_step = 0.1, second = 1e9;  // after a rest nothing jumps
    if (last_time_ != 0) frame.seconds = std::clamp(static_cast<double>(time - last_time_) / second, 0.0, longest_step);
    last_time_ = time;
    frame.beat = std::max(static_cast<double>(beat.predictedDisplayPeriod) / second, 0.0);
    std::vector<XrView> views(pictures_.size(), {XR_TYPE_VIEW});
    const bool known = locate_eyes(time, views);
    frame.input.head_tracked = locate(head_.get(), room_.get(), time, frame.input.head);
    frame.input.hands = actions_->read(room_.get(), time);
    frame.input.focused = session_state_ == XR_SESSION_STATE_FOCUSED;
    frame.input.recentred = recentred_at_ != 0 && time >= recentred_at_;
    if (frame.input.recentred) recentred_at_ = 0;
    for (const XrView& view : views)
      frame.eyes.push_back(
          {pose_of(view.pose), {view.fov.angleLeft, view.fov.angleRight, view.fov.angleDown, view.fov.angleUp}});
    frame.draw = beat.shouldRender && known;
    if (frame.draw)
      for (EyePictures& eye : pictures_) frame.targets.push_back(eye.acquire());
    for (std::size_t i = 0; frame.draw && i < hidden_.size(); ++i) frame.hidden.push_back(&hidden_[i]);
    const Depths depths = draw(frame);
    Shown shown;
    for (std::size_t i = 0; frame.draw && i < pictures_.size(); ++i) {
      pictures_[i].release();
      shown.views.push_back(
          {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW, nullptr, views[i].pose, views[i].fov, pictures_[i].shown()});
      if (pictures_[i].depths() && i < depths.size())
        shown.depths.push_back({XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR, nullptr, pictures_[i].depths()->shown(), 0, 1,
                                static_cast<float>(depths[i].nearest), static_cast<float>(depths[i].farthest)});
    }
    return shown;
  }

  bool locate_eyes(XrTime time, std::vector<XrView>& views) const {
    XrViewLocateInfo wanted{XR_TYPE_VIEW_LOCATE_INFO};
    wanted.viewConfigurationType = two_eyes;
    wanted.displayTime = time;
    wanted.space = room_.get();
    XrViewState state{XR_TYPE_VIEW_STATE};
    std::uint32_t count = 0;
    check(
        xrLocateViews(session_.get(), &wanted, &state, static_cast<std::uint32_t>(views.size()), &count, views.data()),
        "locating the eyes");
    constexpr XrViewStateFlags both = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    return (state.viewStateFlags & both) == both;
  }

  XrResult end_frame(XrTime time, Shown shown) const {
    for (std::size_t i = 0; i < shown.depths.size(); ++i) shown.views[i].next = &shown.depths[i];
    XrCompositionLayerProjection layer{XR_TYPE_COMPOSITION_LAYER_PROJECTION};
    layer.space = room_.get();
    layer.viewCount = static_cast<std::uint32_t>(shown.views.size());
    layer.views = shown.views.data();
    const auto* layers = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
    XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO};
    end.displayTime = time;
    end.environmentBlendMode = blend_;
    end.layerCount = shown.views.empty() ? 0 : 1;
    end.layers = &layers;
    return xrEndFrame(session_.get(), &end);
  }

  static void quietly_release(EyePictures& eye) {
    try {
      eye.release();
    } catch (const HeadsetError&) {
      // The error that made us give it back is the one to report.
    }
  }

  // In the order in which they must be made, the reverse of that in which they go.
  OwnedInstance instance_;
  Extras extras_;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  XrEnvironmentBlendMode blend_ = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  OwnedSession session_;
  OwnedSpace room_, head_;
  std::unique_ptr<HandActions> actions_;
  std::vector<EyePictures> pictures_;
  std::vector<HiddenCorners> hidden_;  // an eye each; none if the runtime cannot tell
  XrSessionState session_state_ = XR_SESSION_STATE_UNKNOWN;
  bool begun_ = false, over_ = false;
  XrTime last_time_ = 0, recentred_at_ = 0;
  std::string in_words_;
};

}  // namespace

bool headsets_built_in() { return true; }

std::unique_ptr<Headset> open_headset(const Gl& gl, const HeadsetOptions& options) {
  return std::make_unique<OpenXrHeadset>(gl, options);
}

}  // namespace odontoscope
