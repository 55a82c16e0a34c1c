#include "engine/headset/bindings.h"

namespace odontoscope {

namespace {

constexpr Binding both(HandAction action, const char* path) { return {action, path, path}; }

constexpr const char* grip = "input/grip/pose";
constexpr const char* aim = "input/aim/pose";
constexpr const char* menu = "input/menu/click";
constexpr Binding haptic = both(HandAction::haptic, "output/haptic");

constexpr Binding simple[] = {both(HandAction::grip, grip), both(HandAction::aim, aim),
                              both(HandAction::trigger, "input/select/click"), both(HandAction::menu, menu), haptic};

// The right hand's menu button belongs to the system.
constexpr Binding touch[] = {both(HandAction::grip, grip),
                             both(HandAction::aim, aim),
                             both(HandAction::trigger, "input/trigger/value"),
                             both(HandAction::grab, "input/squeeze/value"),
                             both(HandAction::stick, "input/thumbstick"),
                             {HandAction::menu, menu, "input/b/click"},
                             haptic};

constexpr Binding index[] = {both(HandAction::grip, grip),
                             both(HandAction::aim, aim),
                             both(HandAction::trigger, "input/trigger/value"),
                             both(HandAction::grab, "input/squeeze/value"),
                             both(HandAction::stick, "input/thumbstick"),
                             both(HandAction::menu, "input/b/click"),
                             haptic};

constexpr Binding vive[] = {both(HandAction::grip, grip),
                            both(HandAction::aim, aim),
                            both(HandAction::trigger, "input/trigger/value"),
                            both(HandAction::grab, "input/squeeze/click"),
                            both(HandAction::stick, "input/trackpad"),
                            both(HandAction::menu, menu),
                            haptic};

constexpr Binding mixed_reality[] = {both(HandAction::grip, grip),
                                     both(HandAction::aim, aim),
                                     both(HandAction::trigger, "input/trigger/value"),
                                     both(HandAction::grab, "input/squeeze/click"),
                                     both(HandAction::stick, "input/thumbstick"),
                                     both(HandAction::menu, menu),
                                     haptic};

constexpr Bindings all[] = {{"khr/simple_controller", "a controller with one button", simple},
                            {"oculus/touch_controller", "Touch controllers", touch},
                            {"valve/index_controller", "Index controllers", index},
                            {"htc/vive_controller", "Vive wands", vive},
                            {"microsoft/motion_controller", "Windows Mixed Reality controllers", mixed_reality}};

}  // namespace

std::span<const Bindings> all_bindings() { return all; }

}  // namespace odontoscope
