#include "engine/ui/interface.h"

#define IMGUI_DEFINE_MATH_OPERATORS
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "engine/ui/fonts.h"
#include "engine/ui/theme.h"

namespace odontoscope {

namespace {

/// ImGui counts keys by numbers of ours.
constexpr std::pair<ImGuiKey_, Key> known_keys[] = {{ImGuiKey_LeftArrow, Key::left},
                                                    {ImGuiKey_RightArrow, Key::right},
                                                    {ImGuiKey_UpArrow, Key::up},
                                                    {ImGuiKey_DownArrow, Key::down},
                                                    {ImGuiKey_Home, Key::home},
                                                    {ImGuiKey_End, Key::end},
                                                    {ImGuiKey_PageUp, Key::page_up},
                                                    {ImGuiKey_PageDown, Key::page_down},
                                                    {ImGuiKey_Enter, Key::enter},
                                                    {ImGuiKey_Escape, Key::escape},
                                                    {ImGuiKey_Backspace, Key::backspace},
                                                    {ImGuiKey_Delete, Key::remove},
                                                    {ImGuiKey_Space, Key::space},
                                                    {ImGuiKey_A, Key::a},
                                                    {ImGuiKey_C, Key::c},
                                                    {ImGuiKey_V, Key::v},
                                                    {ImGuiKey_X, Key::x},
                                                    {ImGuiKey_Y, Key::y},
                                                    {ImGuiKey_Z, Key::z}};

/// Latin with accents, Greek mu and friends, dashes and quotes, arrows.
constexpr ImWchar characters[] = {0x20,   0xff,   0x100,  0x17f,  0x3bc,  0x3bc,  0x2010, 0x2026,
                                  0x2190, 0x2193, 0x2212, 0x2212, 0x2264, 0x2265, 0};

constexpr auto keys_in_all = static_cast<std::size_t>(Key::shift) + 1;

/// Of the panels only while a text is typed: elsewhere they lead through lessons and rides.
bool moves_in_text(Key key) {
  return key == Key::home || key == Key::end || key == Key::page_up || key == Key::page_down;
}

}  // namespace

Interface::Interface(Clipboard clipboard) : clipboard_(std::move(clipboard)) {
  held_.keys_down.resize(keys_in_all);
  held_.keys_pressed.resize(keys_in_all);
  ImGuiContext* before = ImGui::GetCurrentContext();
  context_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // what is remembered is ours to say; see settings.h
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasMouseCursors;
  for (const auto& [theirs, ours] : known_keys) io.KeyMap[theirs] = static_cast<int>(ours);
  io.UserData = this;  // see widgets.cpp
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* self) -> const char* {
    Interface& interface = *static_cast<Interface*>(self);
    if (interface.clipboard_.get) interface.copied_ = interface.clipboard_.get();
    return interface.copied_.c_str();
  };
  io.SetClipboardTextFn = [](void* self, const char* text) {
    Interface& interface = *static_cast<Interface*>(self);
    interface.copied_ = text;
    if (interface.clipboard_.set) interface.clipboard_.set(interface.copied_);
  };
  if (before) ImGui::SetCurrentContext(before);
}

Interface::~Interface() {
  if (ImGui::GetCurrentContext() == context_) ImGui::SetCurrentContext(nullptr);
  ImGui::DestroyContext(context_);
}

void Interface::feed(const Event& event) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  const auto hold = [&io](const Modifiers& with) {
    io.KeyShift = with.shift;
    io.KeyCtrl = with.control;
    io.KeyAlt = with.alt;
  };
  if (const auto* move = std::get_if<MouseMoved>(&event)) {
    io.MousePos = {static_cast<float>(move->x), static_cast<float>(move->y)};
  } else if (const auto* button = std::get_if<MouseButtonChanged>(&event)) {
    const auto i = static_cast<std::size_t>(button->button);
    held_.down[i] = button->down;
    held_.pressed[i] = held_.pressed[i] || button->down;  // a click shorter than a frame is a click all the same
    hold(button->with);
  } else if (const auto* scroll = std::get_if<Scrolled>(&event)) {
    io.MouseWheel += static_cast<float>(scroll->along);
    io.MouseWheelH += static_cast<float>(scroll->across);
  } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
    hold(key->with);
    Key meant = key->key;
    if (meant == Key::enter && by_keys_ && !io.WantTextInput) meant = Key::space;  // ImGui's key that presses
    if (meant == Key::other || meant == Key::tab || (key->down && moves_in_text(meant) && !io.WantTextInput)) return;
    const auto i = static_cast<std::size_t>(meant);
    held_.keys_down[i] = key->down;
    held_.keys_pressed[i] = held_.keys_pressed[i] || key->down;
  } else if (const auto* text = std::get_if<TextTyped>(&event)) {
    io.AddInputCharacter(text->character);
  } else if (std::get_if<FocusLost>(&event)) {
    std::fill(held_.keys_down.begin(), held_.keys_down.end(), false);
    std::fill(std::begin(held_.down), std::end(held_.down), false);
    hold({});
  }
}

void Interface::begin(const FrameInput& input) {
  ImGui::SetCurrentContext(context_);
  if (input.scale != fonts_.scale) make_letters(input.scale);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(input.size.width), static_cast<float>(input.size.height)};
  io.DeltaTime = std::max(static_cast<float>(input.seconds), 1e-4f);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool pressed = std::exchange(held_.pressed[i], false);
    io.MouseDown[i] = held_.down[i] || pressed;
  }
  for (std::size_t i = 0; i < keys_in_all; ++i) {
    io.KeysDown[i] = held_.keys_down[i] || held_.keys_pressed[i];  // likewise
    held_.keys_pressed[i] = false;
  }
  if (by_keys_)
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  else
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  places.clear();
  cut_off.clear();
  ImGui::NewFrame();
}

void Interface::speak(Language language) {
  language_ = std::move(language);
  said_.clear();
  fonts_.scale = 0;  // letters anew
}

std::string Interface::say(const std::string& words) const {
  constexpr std::size_t most_remembered = 4000;
  if (language_.english()) return words;
  if (said_.size() > most_remembered) said_.clear();
  const auto known = said_.find(words);
  return known != said_.end() ? known->second : said_.emplace(words, language_.said(words)).first->second;
}

ImDrawData* Interface::end() {
  ImGui::Render();
  // What the keyboard was on is gone, with its dialog: back to the picture.
  const auto here = [&](const Place& place) {
    return place.id == context_->NavId || place.id == context_->ActiveId || place.id == text_goes_to_;
  };
  if (by_keys_ && !popup_open() && std::none_of(places.begin(), places.end(), here)) leave_keys();
  return ImGui::GetDrawData();
}

void Interface::make_letters(float scale) {
  fonts_.scale = scale;
  ++fonts_.version;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  ImFontGlyphRangesBuilder wanted;
  wanted.AddRanges(characters);
  for (const auto& [english, words] : language_.texts) wanted.AddText(words.c_str());
  wanted.AddText(language_.name.c_str());
  ImVector<ImWchar> ranges;
  wanted.BuildRanges(&ranges);
  fonts_.ranges.assign(ranges.begin(), ranges.end());
  atlas.TexDesiredWidth = 1024;
  const auto add = [&](std::span<const unsigned char> bytes, float size) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = 2;
    config.OversampleV = 1;
    return atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(bytes.data()), static_cast<int>(bytes.size()),
                                      size * scale, &config, fonts_.ranges.data());
  };
  regular = add(regular_font(), theme::text_size);
  bold = add(bold_font(), theme::text_size);
  small = add(regular_font(), theme::small_size);
  large = add(bold_font(), theme::large_size);
  atlas.Build();
  theme::apply(ImGui::GetStyle(), scale);
}

ImFontAtlas& Interface::font_atlas() const {
  ImGui::SetCurrentContext(context_);
  return *ImGui::GetIO().Fonts;
}

bool Interface::covers(double x, double y) const {
  const ImVec2 place(static_cast<float>(x), static_cast<float>(y));
  for (const ImGuiWindow* window : context_->Windows) {
    if (!window->WasActive && !window->Active) continue;
    if (window->Hidden || window->Flags & (ImGuiWindowFlags_NoMouseInputs | ImGuiWindowFlags_ChildWindow)) continue;
    if (window->IsFallbackWindow) continue;
    if (window->Rect().Contains(place)) return true;
  }
  return false;
}

void Interface::step(int by, bool panel) {
  ImGui::SetCurrentContext(context_);
  ImGuiContext& g = *context_;
  std::vector<Place> order;
  for (const Place& place : places)
    if (panel || place.window != ImHashStr("panel")) order.push_back(place);
  if (order.empty() || by == 0) return;
  const unsigned now = text_goes_to_ != 0 ? text_goes_to_ : g.ActiveId != 0 ? g.ActiveId : g.NavId;
  const auto found = std::find_if(order.begin(), order.end(), [now](const Place& place) { return place.id == now; });
  const auto count = static_cast<int>(order.size());
  const int from = !by_keys_ || found == order.end() ? (by > 0 ? -1 : count) : static_cast<int>(found - order.begin());
  const Place& to = order[static_cast<std::size_t>(((from + by) % count + count) % count)];
  ImGuiWindow* window = ImGui::FindWindowByID(to.window);
  if (!window) return;
  const ImRect place({to.left, to.top}, {to.right, to.bottom});
  ImGui::ClearActiveID();
  ImGui::FocusWindow(window);
  ImGui::SetNavID(to.id, ImGuiNavLayer_Main, 0, ImRect(place.Min - window->Pos, place.Max - window->Pos));
  g.NavDisableHighlight = false;
  g.NavDisableMouseHover = true;
  ImGui::ScrollToBringRectIntoView(window, place);
  text_goes_to_ = to.text ? to.id : 0;
  by_keys_ = true;
}

void Interface::leave_keys() {
  by_keys_ = false;
  text_goes_to_ = 0;
  context_->NavDisableHighlight = true;
}

bool Interface::on_control(unsigned id) const {
  return by_keys_ && context_->NavId == id && !context_->NavDisableHighlight;
}

bool Interface::takes_letters(unsigned id) {
  if (text_goes_to_ != id) return false;
  text_goes_to_ = 0;
  return true;
}

bool Interface::popup_open() const { return context_->OpenPopupStack.Size > 0; }

bool Interface::wants_text() const { return context_->IO.WantTextInput; }

Pointer Interface::pointer() const {
  switch (context_->MouseCursor) {
    case ImGuiMouseCursor_TextInput:
      return Pointer::text;
    case ImGuiMouseCursor_Hand:
      return Pointer::hand;
    default:
      return Pointer::arrow;
  }
}

}  // namespace odontoscope
