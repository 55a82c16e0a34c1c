#include "engine/view/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/view/gamepad.h"

namespace odontoscope {

namespace {

constexpr PixelSize smallest{640, 420};

Modifiers modifiers_of(int bits) {
  return {(bits & GLFW_MOD_SHIFT) != 0, (bits & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0, (bits & GLFW_MOD_ALT) != 0};
}

Key key_of(int code) {
  constexpr std::array<std::pair<int, Key>, 30> keys = {{{GLFW_KEY_LEFT, Key::left},
                                                         {GLFW_KEY_RIGHT, Key::right},
                                                         {GLFW_KEY_UP, Key::up},
                                                         {GLFW_KEY_DOWN, Key::down},
                                                         {GLFW_KEY_HOME, Key::home},
                                                         {GLFW_KEY_END, Key::end},
                                                         {GLFW_KEY_PAGE_UP, Key::page_up},
                                                         {GLFW_KEY_PAGE_DOWN, Key::page_down},
                                                         {GLFW_KEY_TAB, Key::tab},
                                                         {GLFW_KEY_ENTER, Key::enter},
                                                         {GLFW_KEY_KP_ENTER, Key::enter},
                                                         {GLFW_KEY_ESCAPE, Key::escape},
                                                         {GLFW_KEY_BACKSPACE, Key::backspace},
                                                         {GLFW_KEY_DELETE, Key::remove},
                                                         {GLFW_KEY_SPACE, Key::space},
                                                         {GLFW_KEY_A, Key::a},
                                                         {GLFW_KEY_C, Key::c},
                                                         {GLFW_KEY_O, Key::o},
                                                         {GLFW_KEY_S, Key::s},
                                                         {GLFW_KEY_V, Key::v},
                                                         {GLFW_KEY_X, Key::x},
                                                         {GLFW_KEY_Y, Key::y},
                                                         {GLFW_KEY_Z, Key::z},
                                                         {GLFW_KEY_F1, Key::f1},
                                                         {GLFW_KEY_F9, Key::f9},
                                                         {GLFW_KEY_F12, Key::f12},
                                                         {GLFW_KEY_LEFT_SHIFT, Key::shift},
                                                         {GLFW_KEY_RIGHT_SHIFT, Key::shift},
                                                         {GLFW_KEY_UNKNOWN, Key::other},
                                                         {GLFW_KEY_LAST, Key::other}}};
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const auto& pair) { return pair.first == code; });
  return found == keys.end() ? Key::other : found->second;
}

/// Letters where the keyboard's layout has them, not where an American one has.
int key_by_layout(int code, int scancode) {
  if (code < GLFW_KEY_A || code > GLFW_KEY_Z) return code;
  const char* printed = glfwGetKeyName(code, scancode);
  if (!printed || printed[1] != '\0') return code;
  if (printed[0] >= 'a' && printed[0] <= 'z') return GLFW_KEY_A + (printed[0] - 'a');
  return code;
}

char place_of(int code) {
  return code >= GLFW_KEY_A && code <= GLFW_KEY_Z ? static_cast<char>('a' + (code - GLFW_KEY_A)) : '\0';
}

static_assert(PadState::axes_in_all == GLFW_GAMEPAD_AXIS_LAST + 1 &&
              PadState::buttons_in_all == GLFW_GAMEPAD_BUTTON_LAST + 1);
static_assert(PadState::left_y == GLFW_GAMEPAD_AXIS_LEFT_Y && PadState::right_x == GLFW_GAMEPAD_AXIS_RIGHT_X &&
              PadState::left_trigger == GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
static_assert(PadState::x == GLFW_GAMEPAD_BUTTON_X && PadState::back == GLFW_GAMEPAD_BUTTON_BACK &&
              PadState::start == GLFW_GAMEPAD_BUTTON_START);
static_assert(PadState::dpad_up == GLFW_GAMEPAD_BUTTON_DPAD_UP && PadState::dpad_left == GLFW_GAMEPAD_BUTTON_DPAD_LEFT);

/// The first gamepad that GLFW knows the layout of.
GamepadChanged gamepad_now() {
  GLFWgamepadstate now;
  int joystick = GLFW_JOYSTICK_1;
  while (joystick <= GLFW_JOYSTICK_LAST && !(glfwJoystickIsGamepad(joystick) && glfwGetGamepadState(joystick, &now)))
    ++joystick;
  if (joystick > GLFW_JOYSTICK_LAST) return {};
  PadState state;
  std::copy(std::begin(now.axes), std::end(now.axes), state.axes.begin());
  std::transform(std::begin(now.buttons), std::end(now.buttons), state.held.begin(),
                 [](unsigned char button) { return button == GLFW_PRESS; });
  return gamepad_from(state);
}

std::optional<MouseButton> button_of(int code) {
  switch (code) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return MouseButton::left;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return MouseButton::right;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return MouseButton::middle;
    default:
      return std::nullopt;
  }
}

}  // namespace

struct Window::Inbox {
  std::vector<Event> events;
  std::array<GLFWcursor*, 4> pointers{};
  Pointer pointer = Pointer::arrow;
  GamepadChanged gamepad;

  static Inbox& of(GLFWwindow* window) { return *static_cast<Inbox*>(glfwGetWindowUserPointer(window)); }
};

Window::Window(const WindowOptions& options) : context_(open_window(options)), inbox_(std::make_unique<Inbox>()) {
  GLFWwindow* window = context_->handle();
  glfwSwapInterval(1);
  glfwSetWindowSizeLimits(window, smallest.width, smallest.height, GLFW_DONT_CARE, GLFW_DONT_CARE);
  inbox_->pointers = {glfwCreateStandardCursor(GLFW_ARROW_CURSOR), glfwCreateStandardCursor(GLFW_HAND_CURSOR),
                      glfwCreateStandardCursor(GLFW_IBEAM_CURSOR), glfwCreateStandardCursor(GLFW_CROSSHAIR_CURSOR)};
  glfwSetWindowUserPointer(window, inbox_.get());
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    int across = 1, down = 1, pixels_across = 1, pixels_down = 1;
    glfwGetWindowSize(w, &across, &down);
    glfwGetFramebufferSize(w, &pixels_across, &pixels_down);
    Inbox::of(w).events.push_back(
        MouseMoved{x * pixels_across / std::max(across, 1), y * pixels_down / std::max(down, 1)});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int code, int action, int bits) {
    if (const auto button = button_of(code))
      Inbox::of(w).events.push_back(MouseButtonChanged{*button, action == GLFW_PRESS, modifiers_of(bits)});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double across, double along) {
    const auto held = [w](int left, int right) {
      return glfwGetKey(w, left) == GLFW_PRESS || glfwGetKey(w, right) == GLFW_PRESS;
    };
    const Modifiers with{held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                         held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL), false};
    Inbox::of(w).events.push_back(Scrolled{across, along, with});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int code, int scancode, int action, int bits) {
    Inbox::of(w).events.push_back(
        KeyChanged{key_of(key_by_layout(code, scancode)), action != GLFW_RELEASE, modifiers_of(bits), place_of(code)});
  });
  glfwSetCharCallback(window,
                      [](GLFWwindow* w, unsigned character) { Inbox::of(w).events.push_back(TextTyped{character}); });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** names) {
    Inbox::of(w).events.push_back(FilesDropped{{names, names + count}});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    if (!focused) Inbox::of(w).events.push_back(FocusLost{});
  });
}

Window::~Window() {
  for (GLFWcursor* pointer : inbox_->pointers)
    if (pointer) glfwDestroyCursor(pointer);
}

PixelSize Window::size() const {
  PixelSize size;
  glfwGetFramebufferSize(context_->handle(), &size.width, &size.height);
  return size;
}

PixelSize Window::outer_size() const {
  PixelSize size;
  glfwGetWindowSize(context_->handle(), &size.width, &size.height);
  return size;
}

float Window::scale() const {
  float across = 1, down = 1;
  glfwGetWindowContentScale(context_->handle(), &across, &down);
  return std::clamp(std::max(across, down), 0.75f, 4.0f);
}

std::vector<Event> Window::events(double timeout_seconds) {
  const auto ask_gamepad = [this] {
    if (const GamepadChanged gamepad = gamepad_now(); gamepad != inbox_->gamepad)
      inbox_->events.push_back(inbox_->gamepad = gamepad);
  };
  constexpr double glance = 1.0 / 60;  // a stick wakes nobody: it is asked, and nothing is drawn meanwhile
  ask_gamepad();
  double left = inbox_->events.empty() ? timeout_seconds : 0;
  for (; left > 0 && inbox_->gamepad.present && inbox_->events.empty(); left -= glance) {
    const double began = glfwGetTime(), most = std::min(left, glance);
    glfwWaitEventsTimeout(most);
    ask_gamepad();
    if (glfwGetTime() - began < 0.5 * most) left = 0;  // woken by what is no event of ours: a new size
  }
  if (left > 0 && inbox_->events.empty())
    glfwWaitEventsTimeout(left);
  else
    glfwPollEvents();
  ask_gamepad();
  return std::exchange(inbox_->events, {});
}

bool Window::closing() const { return glfwWindowShouldClose(context_->handle()); }

void Window::keep_open() { glfwSetWindowShouldClose(context_->handle(), GLFW_FALSE); }

void Window::show() { glfwSwapBuffers(context_->handle()); }

void Window::set_paced(bool paced) { glfwSwapInterval(paced ? 1 : 0); }

void Window::set_title(const std::string& title) { glfwSetWindowTitle(context_->handle(), title.c_str()); }

void Window::set_pointer(Pointer pointer) {
  if (pointer == inbox_->pointer) return;
  if ((pointer == Pointer::caught) != (inbox_->pointer == Pointer::caught))
    glfwSetInputMode(context_->handle(), GLFW_CURSOR,
                     pointer == Pointer::caught ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  inbox_->pointer = pointer;
  if (pointer != Pointer::none && pointer != Pointer::caught)
    glfwSetCursor(context_->handle(), inbox_->pointers[static_cast<std::size_t>(pointer)]);
}

std::string Window::clipboard() const {
  const char* text = glfwGetClipboardString(context_->handle());
  return text ? text : "";
}

void Window::set_clipboard(const std::string& text) { glfwSetClipboardString(context_->handle(), text.c_str()); }

}  // namespace odontoscope
