#include "engine/headset/openxr_actions.h"

#include <cstring>
#include <vector>

#include "engine/headset/headset.h"

namespace odontoscope {

namespace {

struct Described {
  HandAction action;
  const char* name;
  const char* words;
  XrActionType type;
};

constexpr Described described[hand_actions] = {
    {HandAction::grip, "grip", "Where the hand is", XR_ACTION_TYPE_POSE_INPUT},
    {HandAction::aim, "aim", "Where the hand points", XR_ACTION_TYPE_POSE_INPUT},
    {HandAction::trigger, "trigger", "Choose, enter, glide", XR_ACTION_TYPE_FLOAT_INPUT},
    {HandAction::grab, "grab", "Hold the tooth", XR_ACTION_TYPE_FLOAT_INPUT},
    {HandAction::stick, "stick", "Turn and move", XR_ACTION_TYPE_VECTOR2F_INPUT},
    {HandAction::menu, "menu", "Panel; held: back, true size", XR_ACTION_TYPE_BOOLEAN_INPUT},
    {HandAction::haptic, "haptic", "What the hand feels", XR_ACTION_TYPE_VIBRATION_OUTPUT}};

constexpr const char* hand_paths[2] = {"/user/hand/left", "/user/hand/right"};

template <std::size_t size>
void put(char (&field)[size], const char* text) {
  std::strncpy(field, text, size - 1);
  field[size - 1] = '\0';
}

}  // namespace

Pose pose_of(const XrPosef& pose) {
  const glm::dquat turn(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  return {{pose.position.x, pose.position.y, pose.position.z}, glm::normalize(turn)};
}

bool locate(XrSpace where, XrSpace base, XrTime time, Pose& pose) {
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  check(xrLocateSpace(where, base, time, &location), "locating the head and the hands");
  constexpr XrSpaceLocationFlags both = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
  if ((location.locationFlags & both) != both) return false;
  pose = pose_of(location.pose);
  return true;
}

HandActions::HandActions(XrInstance instance, XrSession session) : instance_(instance), session_(session) {
  XrActionSetCreateInfo set{XR_TYPE_ACTION_SET_CREATE_INFO};
  put(set.actionSetName, "hands");
  put(set.localizedActionSetName, "Hands");
  check(xrCreateActionSet(instance, &set, set_.fill()), "making the controllers' actions");
  for (std::size_t hand = 0; hand < 2; ++hand) hands_[hand] = path(hand_paths[hand]);
  for (const Described& wanted : described) {
    XrActionCreateInfo info{XR_TYPE_ACTION_CREATE_INFO};
    put(info.actionName, wanted.name);
    put(info.localizedActionName, wanted.words);
    info.actionType = wanted.type;
    info.countSubactionPaths = 2;
    info.subactionPaths = hands_.data();
    check(xrCreateAction(set_.get(), &info, &actions_[static_cast<std::size_t>(wanted.action)]),
          "making the controllers' actions");
  }
  bool any = false;
  for (const Bindings& bindings : all_bindings()) any = suggest(bindings) || any;
  if (!any)
    throw HeadsetError("openxr-failed", "the OpenXR runtime knows none of the controllers that this program knows",
                       "Update the headset's software.");
  XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO};
  const XrActionSet attached = set_.get();
  attach.countActionSets = 1;
  attach.actionSets = &attached;
  check(xrAttachSessionActionSets(session, &attach), "attaching the controllers' actions");
  for (std::size_t hand = 0; hand < 2; ++hand) {
    XrActionSpaceCreateInfo space{XR_TYPE_ACTION_SPACE_CREATE_INFO};
    space.subactionPath = hands_[hand];
    space.poseInActionSpace.orientation.w = 1;
    space.action = action(HandAction::grip);
    check(xrCreateActionSpace(session, &space, grips_[hand].fill()), "following the hands");
    space.action = action(HandAction::aim);
    check(xrCreateActionSpace(session, &space, aims_[hand].fill()), "following the hands");
  }
}

XrPath HandActions::path(const std::string& text) const {
  XrPath found = XR_NULL_PATH;
  check(xrStringToPath(instance_, text.c_str(), &found), "naming a path");
  return found;
}

bool HandActions::suggest(const Bindings& bindings) const {
  std::vector<XrActionSuggestedBinding> suggested;
  for (const Binding& binding : bindings.bindings) {
    if (binding.left)
      suggested.push_back({action(binding.action), path(std::string(hand_paths[0]) + "/" + binding.left)});
    if (binding.right)
      suggested.push_back({action(binding.action), path(std::string(hand_paths[1]) + "/" + binding.right)});
  }
  XrInteractionProfileSuggestedBinding suggestion{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
  suggestion.interactionProfile = path(std::string("/interaction_profiles/") + bindings.profile);
  suggestion.countSuggestedBindings = static_cast<std::uint32_t>(suggested.size());
  suggestion.suggestedBindings = suggested.data();
  const XrResult result = xrSuggestInteractionProfileBindings(instance_, &suggestion);
  if (result == XR_ERROR_PATH_UNSUPPORTED) return false;  // a runtime that does not know this controller
  check(result, "offering the controllers' bindings");
  return true;
}

std::array<HandInput, 2> HandActions::read(XrSpace room, XrTime time) const {
  std::array<HandInput, 2> hands;
  const XrActiveActionSet active{set_.get(), XR_NULL_PATH};
  XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO};
  sync.countActiveActionSets = 1;
  sync.activeActionSets = &active;
  const XrResult result = xrSyncActions(session_, &sync);
  check(result, "reading the controllers");
  if (result == XR_SESSION_NOT_FOCUSED) return hands;
  for (std::size_t i = 0; i < 2; ++i) {
    HandInput& hand = hands[i];
    XrActionStateGetInfo get{XR_TYPE_ACTION_STATE_GET_INFO};
    get.subactionPath = hands_[i];
    get.action = action(HandAction::grip);
    XrActionStatePose held{XR_TYPE_ACTION_STATE_POSE};
    check(xrGetActionStatePose(session_, &get, &held), "reading the controllers");
    hand.tracked = held.isActive && locate(grips_[i].get(), room, time, hand.grip);
    if (hand.tracked && !locate(aims_[i].get(), room, time, hand.aim)) hand.aim = hand.grip;
    const auto number = [&](HandAction which, bool* is_there = nullptr) {
      get.action = action(which);
      XrActionStateFloat state{XR_TYPE_ACTION_STATE_FLOAT};
      check(xrGetActionStateFloat(session_, &get, &state), "reading the controllers");
      if (is_there) *is_there = state.isActive;
      return state.isActive ? static_cast<double>(state.currentState) : 0.0;
    };
    hand.trigger = number(HandAction::trigger);
    hand.grab = number(HandAction::grab, &hand.can_grab);
    get.action = action(HandAction::stick);
    XrActionStateVector2f stick{XR_TYPE_ACTION_STATE_VECTOR2F};
    check(xrGetActionStateVector2f(session_, &get, &stick), "reading the controllers");
    if (stick.isActive) hand.stick = {stick.currentState.x, stick.currentState.y};
    get.action = action(HandAction::menu);
    XrActionStateBoolean menu{XR_TYPE_ACTION_STATE_BOOLEAN};
    check(xrGetActionStateBoolean(session_, &get, &menu), "reading the controllers");
    hand.menu = menu.isActive && menu.currentState;
  }
  return hands;
}

void HandActions::pulse(std::size_t hand, double strength, double seconds) const {
  XrHapticActionInfo info{XR_TYPE_HAPTIC_ACTION_INFO};
  info.action = action(HandAction::haptic);
  info.subactionPath = hands_[hand];
  XrHapticVibration vibration{XR_TYPE_HAPTIC_VIBRATION};
  constexpr double nanoseconds = 1e9;
  vibration.duration = static_cast<XrDuration>(seconds * nanoseconds);
  vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
  vibration.amplitude = static_cast<float>(strength);
  const XrResult result =
      xrApplyHapticFeedback(session_, &info, reinterpret_cast<const XrHapticBaseHeader*>(&vibration));
  if (result != XR_SESSION_NOT_FOCUSED) check(result, "letting the hand feel something");
}

std::string HandActions::controllers() const {
  std::string words;
  for (const XrPath hand : hands_) {
    XrInteractionProfileState state{XR_TYPE_INTERACTION_PROFILE_STATE};
    if (XR_FAILED(xrGetCurrentInteractionProfile(session_, hand, &state)) || state.interactionProfile == XR_NULL_PATH)
      continue;
    for (const Bindings& bindings : all_bindings()) {
      if (path(std::string("/interaction_profiles/") + bindings.profile) != state.interactionProfile) continue;
      if (words.find(bindings.words) == std::string::npos)
        words += (words.empty() ? "" : ", ") + std::string(bindings.words);
    }
  }
  return words.empty() ? "no controllers" : words;
}

}  // namespace odontoscope
