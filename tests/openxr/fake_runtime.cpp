// The library that the loader opens. One instance, one session: OpenXR's calls carry nothing that a test could put its
// own words into, so that the state is the library's own.
#include "tests/openxr/fake_runtime.h"

#include <cstring>
#include <vector>

#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#include <GL/glx.h>
#include <openxr/openxr_platform.h>

namespace odontoscope::testing_support {

namespace {

FakeRuntime& fake() {
  static FakeRuntime state;
  return state;
}

/// Any handle that is not null.
template <class Handle>
Handle handle(std::size_t number) {
  return reinterpret_cast<Handle>(number + 1);
}

XrResult misused(const char* what) {
  fake().misuse.emplace_back(what);
  return XR_ERROR_CALL_ORDER_INVALID;
}

template <class Element, class From>
XrResult fill(const std::vector<From>& from, std::uint32_t capacity, std::uint32_t* count, Element* to) {
  *count = static_cast<std::uint32_t>(from.size());
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
  for (const From& one : from) *to++ = one;
  return XR_SUCCESS;
}

template <std::size_t size>
void put(char (&field)[size], const char* text) {
  std::strncpy(field, text, size - 1);
  field[size - 1] = '\0';
}

XrResult extensions(const char*, std::uint32_t capacity, std::uint32_t* count, XrExtensionProperties* to) {
  std::vector<XrExtensionProperties> known;
  for (const std::string& name : fake().extensions) {
    known.push_back({XR_TYPE_EXTENSION_PROPERTIES});
    put(known.back().extensionName, name.c_str());
    known.back().extensionVersion = 1;
  }
  return fill(known, capacity, count, to);
}

XrResult create_instance(const XrInstanceCreateInfo* info, XrInstance* instance) {
  fake().enabled.assign(info->enabledExtensionNames, info->enabledExtensionNames + info->enabledExtensionCount);
  ++fake().instances;
  *instance = handle<XrInstance>(0);
  return XR_SUCCESS;
}

XrResult destroy_instance(XrInstance) {
  if (fake().sessions > 0) fake().misuse.emplace_back("xrDestroyInstance before its session");
  --fake().instances;
  return XR_SUCCESS;
}

XrResult instance_properties(XrInstance, XrInstanceProperties* properties) {
  properties->runtimeVersion = XR_MAKE_VERSION(1, 2, 3);
  put(properties->runtimeName, "Fake");
  return XR_SUCCESS;
}

XrResult system(XrInstance, const XrSystemGetInfo*, XrSystemId* id) {
  *id = 1;
  return XR_SUCCESS;
}

XrResult system_properties(XrInstance, XrSystemId, XrSystemProperties* properties) {
  put(properties->systemName, "Head of straw");
  return XR_SUCCESS;
}

XrResult blend_modes(XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity, std::uint32_t* count,
                     XrEnvironmentBlendMode* to) {
  return fill(std::vector<XrEnvironmentBlendMode>{XR_ENVIRONMENT_BLEND_MODE_OPAQUE}, capacity, count, to);
}

XrResult configuration_views(XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity,
                             std::uint32_t* count, XrViewConfigurationView* to) {
  const std::uint32_t side = fake().side;
  return fill(
      std::vector<XrViewConfigurationView>(2, {XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, side, 4096, side, 4096, 1, 4}),
      capacity, count, to);
}

XrResult requirements(XrInstance, XrSystemId, XrGraphicsRequirementsOpenGLKHR* needed) {
  needed->minApiVersionSupported = XR_MAKE_VERSION(4, 0, 0);
  needed->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
  return XR_SUCCESS;
}

XrResult create_session(XrInstance, const XrSessionCreateInfo*, XrSession* session) {
  *session = handle<XrSession>(0);
  ++fake().sessions;
  fake().tell(XR_SESSION_STATE_IDLE);
  if (fake().obliging)
    for (const XrSessionState state :
         {XR_SESSION_STATE_READY, XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED})
      fake().tell(state);
  return XR_SUCCESS;
}

XrResult destroy_session(XrSession) {
  --fake().sessions;
  fake().running = false;
  return XR_SUCCESS;
}

XrResult poll(XrInstance, XrEventDataBuffer* event) {
  if (fake().events.empty()) return XR_EVENT_UNAVAILABLE;
  *event = fake().events.front();
  fake().events.erase(fake().events.begin());
  if (event->type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED)
    fake().state = reinterpret_cast<const XrEventDataSessionStateChanged*>(event)->state;
  return XR_SUCCESS;
}

XrResult begin_session(XrSession, const XrSessionBeginInfo*) {
  if (fake().running) return XR_ERROR_SESSION_RUNNING;
  if (fake().state != XR_SESSION_STATE_READY) return misused("xrBeginSession of a session that is not ready");
  fake().running = true;
  return XR_SUCCESS;
}

XrResult end_session(XrSession) {
  if (!fake().running) return misused("xrEndSession of a session that does not run");
  if (fake().state != XR_SESSION_STATE_STOPPING) {
    fake().misuse.emplace_back("xrEndSession of a session that is not to stop");
    return XR_ERROR_SESSION_NOT_STOPPING;
  }
  if (fake().begun > static_cast<int>(fake().ended.size())) fake().misuse.emplace_back("xrEndSession within a frame");
  fake().running = false;
  return XR_SUCCESS;
}

XrResult request_exit(XrSession) {
  if (!fake().running) {
    fake().misuse.emplace_back("xrRequestExitSession of a session that does not run");
    return XR_ERROR_SESSION_NOT_RUNNING;
  }
  fake().exit_requested = true;
  if (fake().obliging)
    for (const XrSessionState state : {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED,
                                       XR_SESSION_STATE_STOPPING, XR_SESSION_STATE_IDLE, XR_SESSION_STATE_EXITING})
      fake().tell(state);
  return XR_SUCCESS;
}

XrResult wait_frame(XrSession, const XrFrameWaitInfo*, XrFrameState* beat) {
  if (!fake().running) {
    fake().misuse.emplace_back("xrWaitFrame of a session that does not run");
    return XR_ERROR_SESSION_NOT_RUNNING;
  }
  constexpr XrTime period = 11'111'111;
  fake().time += period;
  ++fake().waited;
  beat->predictedDisplayTime = fake().time;
  beat->predictedDisplayPeriod = period;
  beat->shouldRender = fake().should_render;
  return XR_SUCCESS;
}

XrResult begin_frame(XrSession, const XrFrameBeginInfo*) {
  if (fake().waited <= fake().begun) return misused("xrBeginFrame without xrWaitFrame");
  ++fake().begun;
  if (fake().begun == static_cast<int>(fake().ended.size()) + 1) return XR_SUCCESS;
  fake().misuse.emplace_back("xrBeginFrame before the frame before was ended");
  return XR_FRAME_DISCARDED;
}

FakeSwapchain* swapchain_of(XrSwapchain which) { return &fake().swapchains[reinterpret_cast<std::size_t>(which) - 1]; }

FakeFrame seen_in(const XrFrameEndInfo& end) {
  FakeFrame frame{fake().should_render, 0, {}, {}};
  for (std::uint32_t i = 0; i < end.layerCount; ++i) {
    if (end.layers[i]->type != XR_TYPE_COMPOSITION_LAYER_PROJECTION) continue;
    const auto& layer = *reinterpret_cast<const XrCompositionLayerProjection*>(end.layers[i]);
    for (std::uint32_t eye = 0; eye < layer.viewCount; ++eye) {
      ++frame.views;
      const FakeSwapchain& picture = *swapchain_of(layer.views[eye].subImage.swapchain);
      if (picture.acquired || picture.released < 0)
        fake().misuse.emplace_back("xrEndFrame with a picture that was not given back");
      frame.images.push_back(picture.released);
      const auto* next = static_cast<const XrBaseInStructure*>(layer.views[eye].next);
      if (!next || next->type != XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR) continue;
      const auto& depth = *reinterpret_cast<const XrCompositionLayerDepthInfoKHR*>(next);
      const FakeSwapchain& depths = *swapchain_of(depth.subImage.swapchain);
      if (depths.acquired || depths.released < 0)
        fake().misuse.emplace_back("xrEndFrame with a depth that was not given back");
      frame.depths.push_back(
          {depth.minDepth, depth.maxDepth, depth.nearZ, depth.farZ, depth.subImage.swapchain, depths.released});
    }
  }
  return frame;
}

XrResult end_frame(XrSession, const XrFrameEndInfo* end) {
  if (fake().begun <= static_cast<int>(fake().ended.size())) return misused("xrEndFrame without xrBeginFrame");
  fake().ended.push_back(seen_in(*end));
  return XR_SUCCESS;
}

XrResult views(XrSession, const XrViewLocateInfo*, XrViewState* state, std::uint32_t capacity, std::uint32_t* count,
               XrView* to) {
  *count = 2;
  if (capacity == 0) return XR_SUCCESS;
  state->viewStateFlags =
      fake().eyes_known ? XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT : 0;
  for (int eye = 0; eye < 2; ++eye) {
    to[eye].pose = fake().head;
    to[eye].pose.position.x += eye == 0 ? -0.032f : 0.032f;
    to[eye].fov = {-0.8f, 0.8f, 0.8f, -0.8f};
  }
  return XR_SUCCESS;
}

XrResult locate(XrSpace, XrSpace, XrTime, XrSpaceLocation* location) {
  location->locationFlags =
      fake().eyes_known ? XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT : 0;
  location->pose = fake().head;
  return XR_SUCCESS;
}

XrResult create_space(XrSession, const XrReferenceSpaceCreateInfo*, XrSpace* space) {
  *space = handle<XrSpace>(0);
  return XR_SUCCESS;
}

XrResult create_action_space(XrSession, const XrActionSpaceCreateInfo*, XrSpace* space) {
  *space = handle<XrSpace>(1);
  return XR_SUCCESS;
}

XrResult destroy_space(XrSpace) { return XR_SUCCESS; }

XrResult formats(XrSession, std::uint32_t capacity, std::uint32_t* count, std::int64_t* to) {
  return fill(fake().formats, capacity, count, to);
}

XrResult create_swapchain(XrSession, const XrSwapchainCreateInfo* info, XrSwapchain* made) {
  FakeSwapchain swapchain;
  swapchain.info = *info;
  const bool depth = info->usageFlags & XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  swapchain.images.resize(3);
  const Gl& gl = *fake().gl;
  gl.GenTextures(3, swapchain.images.data());
  for (const GLuint image : swapchain.images) {
    gl.BindTexture(GL_TEXTURE_2D, image);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(info->format), static_cast<GLsizei>(info->width),
                  static_cast<GLsizei>(info->height), 0, depth ? GL_DEPTH_COMPONENT : GL_RGBA,
                  depth ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
  }
  fake().swapchains.push_back(swapchain);
  *made = handle<XrSwapchain>(fake().swapchains.size() - 1);
  return XR_SUCCESS;
}

XrResult destroy_swapchain(XrSwapchain which) {
  FakeSwapchain& swapchain = *swapchain_of(which);
  if (swapchain.destroyed) fake().misuse.emplace_back("xrDestroySwapchain twice");
  swapchain.destroyed = true;
  fake().gl->DeleteTextures(static_cast<GLsizei>(swapchain.images.size()), swapchain.images.data());
  return XR_SUCCESS;
}

XrResult images(XrSwapchain which, std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageBaseHeader* to) {
  std::vector<XrSwapchainImageOpenGLKHR> pictures;
  for (const GLuint image : swapchain_of(which)->images)
    pictures.push_back({XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, image});
  return fill(pictures, capacity, count, reinterpret_cast<XrSwapchainImageOpenGLKHR*>(to));
}

XrResult acquire(XrSwapchain which, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
  FakeSwapchain& swapchain = *swapchain_of(which);
  if (swapchain.acquired) return misused("xrAcquireSwapchainImage before the image before was given back");
  swapchain.acquired = true;
  swapchain.waited = false;
  *index = static_cast<std::uint32_t>(swapchain.next);
  return XR_SUCCESS;
}

XrResult wait_image(XrSwapchain which, const XrSwapchainImageWaitInfo*) {
  FakeSwapchain& swapchain = *swapchain_of(which);
  if (!swapchain.acquired || swapchain.waited) return misused("xrWaitSwapchainImage without xrAcquireSwapchainImage");
  swapchain.waited = true;
  return XR_SUCCESS;
}

XrResult release(XrSwapchain which, const XrSwapchainImageReleaseInfo*) {
  FakeSwapchain& swapchain = *swapchain_of(which);
  if (!swapchain.acquired || !swapchain.waited) return misused("xrReleaseSwapchainImage without xrWaitSwapchainImage");
  swapchain.acquired = false;
  swapchain.released = swapchain.next;
  swapchain.next = (swapchain.next + 1) % static_cast<int>(swapchain.images.size());
  return XR_SUCCESS;
}

XrResult mask(XrSession, XrViewConfigurationType, std::uint32_t, XrVisibilityMaskTypeKHR, XrVisibilityMaskKHR* filled) {
  const auto count = static_cast<std::uint32_t>(fake().hidden_corners.size());
  filled->vertexCountOutput = filled->indexCountOutput = count;
  if (filled->vertexCapacityInput == 0 && filled->indexCapacityInput == 0) return XR_SUCCESS;
  if (filled->vertexCapacityInput < count || filled->indexCapacityInput < count) return XR_ERROR_SIZE_INSUFFICIENT;
  for (std::uint32_t i = 0; i < count; ++i) {
    filled->vertices[i] = fake().hidden_corners[i];
    filled->indices[i] = i;
  }
  return XR_SUCCESS;
}

XrResult path(XrInstance, const char* text, XrPath* made) {
  *made = std::hash<std::string>{}(text) | 1u;
  return XR_SUCCESS;
}

XrResult create_action_set(XrInstance, const XrActionSetCreateInfo*, XrActionSet* set) {
  *set = handle<XrActionSet>(0);
  return XR_SUCCESS;
}

XrResult destroy_action_set(XrActionSet) { return XR_SUCCESS; }

XrResult create_action(XrActionSet, const XrActionCreateInfo*, XrAction* action) {
  *action = handle<XrAction>(0);
  return XR_SUCCESS;
}

XrResult suggest(XrInstance, const XrInteractionProfileSuggestedBinding*) { return XR_SUCCESS; }
XrResult attach(XrSession, const XrSessionActionSetsAttachInfo*) { return XR_SUCCESS; }

XrResult profile(XrSession, XrPath, XrInteractionProfileState* state) {
  state->interactionProfile = XR_NULL_PATH;
  return XR_SUCCESS;
}

XrResult sync(XrSession, const XrActionsSyncInfo*) {
  return fake().state == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

/// As the specification has it: without the focus every action rests.
bool active() { return fake().state == XR_SESSION_STATE_FOCUSED && fake().hands_held; }

XrResult boolean_of(XrSession, const XrActionStateGetInfo*, XrActionStateBoolean* state) {
  state->isActive = active();
  state->currentState = XR_FALSE;
  return XR_SUCCESS;
}

XrResult float_of(XrSession, const XrActionStateGetInfo*, XrActionStateFloat* state) {
  state->isActive = active();
  state->currentState = active() ? fake().trigger : 0;
  return XR_SUCCESS;
}

XrResult vector_of(XrSession, const XrActionStateGetInfo*, XrActionStateVector2f* state) {
  state->isActive = active();
  state->currentState = {0, 0};
  return XR_SUCCESS;
}

XrResult pose_of(XrSession, const XrActionStateGetInfo*, XrActionStatePose* state) {
  state->isActive = active();
  return XR_SUCCESS;
}

XrResult function(XrInstance instance, const char* name, PFN_xrVoidFunction* found);

/// `real`, unless the test has given an answer in its place.
template <auto real>
struct Answering;
template <class... Arguments, XrResult (*real)(Arguments...)>
struct Answering<real> {
  static const char*& name() {
    static const char* its = nullptr;
    return its;
  }
  static XrResult XRAPI_CALL call(Arguments... arguments) {
    const auto said = fake().answers.find(name());
    return said != fake().answers.end() ? said->second : real(arguments...);
  }
};

template <auto real>
PFN_xrVoidFunction answering(const char* name) {
  Answering<real>::name() = name;
  return reinterpret_cast<PFN_xrVoidFunction>(&Answering<real>::call);
}

const std::map<std::string, PFN_xrVoidFunction>& functions() {
#define ENTRY(name, real) \
  { #name, answering < real>(#name) }
  static const std::map<std::string, PFN_xrVoidFunction> all = {
      {"xrGetInstanceProcAddr", reinterpret_cast<PFN_xrVoidFunction>(&function)},
      ENTRY(xrEnumerateInstanceExtensionProperties, extensions),
      ENTRY(xrCreateInstance, create_instance),
      ENTRY(xrDestroyInstance, destroy_instance),
      ENTRY(xrGetInstanceProperties, instance_properties),
      ENTRY(xrGetSystem, system),
      ENTRY(xrGetSystemProperties, system_properties),
      ENTRY(xrEnumerateEnvironmentBlendModes, blend_modes),
      ENTRY(xrEnumerateViewConfigurationViews, configuration_views),
      ENTRY(xrGetOpenGLGraphicsRequirementsKHR, requirements),
      ENTRY(xrCreateSession, create_session),
      ENTRY(xrDestroySession, destroy_session),
      ENTRY(xrPollEvent, poll),
      ENTRY(xrBeginSession, begin_session),
      ENTRY(xrEndSession, end_session),
      ENTRY(xrRequestExitSession, request_exit),
      ENTRY(xrWaitFrame, wait_frame),
      ENTRY(xrBeginFrame, begin_frame),
      ENTRY(xrEndFrame, end_frame),
      ENTRY(xrLocateViews, views),
      ENTRY(xrLocateSpace, locate),
      ENTRY(xrCreateReferenceSpace, create_space),
      ENTRY(xrCreateActionSpace, create_action_space),
      ENTRY(xrDestroySpace, destroy_space),
      ENTRY(xrEnumerateSwapchainFormats, formats),
      ENTRY(xrCreateSwapchain, create_swapchain),
      ENTRY(xrDestroySwapchain, destroy_swapchain),
      ENTRY(xrEnumerateSwapchainImages, images),
      ENTRY(xrAcquireSwapchainImage, acquire),
      ENTRY(xrWaitSwapchainImage, wait_image),
      ENTRY(xrReleaseSwapchainImage, release),
      ENTRY(xrGetVisibilityMaskKHR, mask),
      ENTRY(xrStringToPath, path),
      ENTRY(xrCreateActionSet, create_action_set),
      ENTRY(xrDestroyActionSet, destroy_action_set),
      ENTRY(xrCreateAction, create_action),
      ENTRY(xrSuggestInteractionProfileBindings, suggest),
      ENTRY(xrAttachSessionActionSets, attach),
      ENTRY(xrGetCurrentInteractionProfile, profile),
      ENTRY(xrSyncActions, sync),
      ENTRY(xrGetActionStateBoolean, boolean_of),
      ENTRY(xrGetActionStateFloat, float_of),
      ENTRY(xrGetActionStateVector2f, vector_of),
      ENTRY(xrGetActionStatePose, pose_of)};
#undef ENTRY
  return all;
}

XrResult function(XrInstance, const char* name, PFN_xrVoidFunction* found) {
  const auto known = functions().find(name);
  *found = known == functions().end() ? nullptr : known->second;
  return *found ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED;
}

/// What the loader and a runtime tell each other, as OpenXR's document on its loader has it.
struct LoaderInfo {
  std::uint32_t structure, version;
  std::size_t size;
  std::uint32_t least_interface, most_interface;
  XrVersion least_api, most_api;
};
struct RuntimeRequest {
  std::uint32_t structure, version;
  std::size_t size;
  std::uint32_t interface;
  XrVersion api;
  PFN_xrGetInstanceProcAddr get;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(const LoaderInfo*,
                                                                                             RuntimeRequest* request) {
  request->interface = 1;
  request->api = XR_MAKE_VERSION(1, 0, 0);
  request->get = &function;
  return XR_SUCCESS;
}

extern "C" __attribute__((visibility("default"))) FakeRuntime* odontoscope_fake_runtime() { return &fake(); }

}  // namespace odontoscope::testing_support
