#include "engine/ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "engine/ui/theme.h"

namespace odontoscope::widgets {

float scaled(float size) { return size * ImGui::GetFontSize() / theme::text_size; }

namespace {

Interface& interface_now() { return *static_cast<Interface*>(ImGui::GetIO().UserData); }

void note_place(ImGuiID id, bool text) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  interface_now().places.push_back({id, low.x, low.y, high.x, high.y, ImGui::GetCurrentWindowRead()->ID, text});
}

bool keyboard_here() { return interface_now().on_control(ImGui::GetItemID()); }

/// An invisible button whose place can be asked for, with a frame while the keyboard is on it.
bool area(const char* id, const ImVec2& size) {
  const bool pressed = ImGui::InvisibleButton(id, size);
  note_place(ImGui::GetItemID(), false);
  if (keyboard_here()) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float out = scaled(2);
    ImGui::GetWindowDrawList()->AddRect({low.x - out, low.y - out}, {high.x + out, high.y + out}, theme::accent,
                                        scaled(6), 0, scaled(2));
  }
  return pressed;
}

/// Left and right by a hundredth, with Shift by a thousandth, but never by less than what is shown.
double moved_by_keys(double value, double low, double high, const char* format) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto pressed = [&](ImGuiKey_ key) { return ImGui::IsKeyPressed(io.KeyMap[key]); };
  const int way = (pressed(ImGuiKey_RightArrow) ? 1 : 0) - (pressed(ImGuiKey_LeftArrow) ? 1 : 0);
  if (way == 0) return value;
  ImGui::NavMoveRequestCancel();  // not to the neighbour
  const char* point = std::strchr(format, '.');
  const bool fixed = point && std::strchr(point, 'f');
  const double least = fixed ? std::pow(10.0, -std::atoi(point + 1)) : 0,
               step = std::max((io.KeyShift ? 0.001 : 0.01) * (high - low), least);
  const double wanted = value + way * step;
  return std::clamp(fixed ? least * std::round(wanted / least) : wanted, low, high);
}

}  // namespace

bool section(const Interface& interface, const char* title, AtFirst at_first) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID(title);
  bool open = storage.GetBool(id, at_first == AtFirst::open);
  ImGui::Dummy({0, 0});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({corner.x, corner.y - scaled(4)}, {corner.x + width, corner.y - scaled(4)}, theme::line);
  if (area(title, {width, height})) storage.SetBool(id, open = !open);
  const ImU32 colour = ImGui::IsItemHovered() ? theme::accent : theme::text;
  ImGui::PushFont(interface.bold);
  list.AddText({corner.x, corner.y + 0.5f * (height - ImGui::GetFontSize())}, colour, say(title).c_str());
  ImGui::PopFont();
  const float s = scaled(4);
  const ImVec2 middle(corner.x + width - 2 * s, corner.y + height / 2);
  const ImVec2 down[] = {
      {middle.x - s, middle.y - s / 2}, {middle.x, middle.y + s / 2}, {middle.x + s, middle.y - s / 2}};
  const ImVec2 aside[] = {
      {middle.x - s / 2, middle.y - s}, {middle.x + s / 2, middle.y}, {middle.x - s / 2, middle.y + s}};
  list.AddPolyline(open ? down : aside, 3, ImGui::IsItemHovered() ? theme::accent : theme::quiet, 0, scaled(1.6f));
  return open;
}

std::string say(const std::string& words) { return interface_now().say(words); }

void expect_room(const std::string& said, float width) {
  if (ImGui::CalcTextSize(said.c_str()).x > width + 0.5f) interface_now().cut_off.push_back(said);
}

void text(const std::string& words) { ImGui::TextUnformatted(say(words).c_str()); }

void wrapped(const std::string& words) { as_written(say(words)); }

void as_written(const std::string& words) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
}

void remark(const Interface& interface, const std::string& words) {
  ImGui::PushFont(interface.small);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::quiet);
  wrapped(words);
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

bool choice(const char* id, int& chosen, const std::vector<const char*>& words) {
  ImGui::PushID(id);
  bool changed = false;
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, theme::raised, scaled(6));
  std::vector<std::string> said;
  float weight = 0;  // long words get more room
  for (const char* word : words) {
    said.push_back(say(word));
    weight += ImGui::CalcTextSize(said.back().c_str()).x + scaled(16);
  }
  float left = corner.x;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const ImVec2 size = ImGui::CalcTextSize(said[i].c_str());
    const float share = width * (size.x + scaled(16)) / weight;
    expect_room(said[i], share);
    ImGui::SetCursorScreenPos({left, corner.y});
    if (area(words[i], {share, height}) && chosen != static_cast<int>(i)) {
      chosen = static_cast<int>(i);
      changed = true;
    }
    const bool active = chosen == static_cast<int>(i);
    const float inset = scaled(2);
    if (active || ImGui::IsItemHovered())
      list.AddRectFilled({left + inset, corner.y + inset}, {left + share - inset, corner.y + height - inset},
                         active ? theme::accent_dark : theme::hovered, scaled(5));
    list.AddText({left + 0.5f * (share - size.x), corner.y + 0.5f * (height - size.y)},
                 active ? theme::text : theme::quiet, said[i].c_str());
    left += share;
  }
  ImGui::PopID();
  return changed;
}

bool toggle(const char* words, bool& on) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = scaled(24), width = ImGui::GetContentRegionAvail().x;
  const bool pressed = area(words, {width, height});
  if (pressed) on = !on;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = scaled(8), track = scaled(30);
  expect_room(say(words), width - track - scaled(10));
  const float middle = corner.y + height / 2;
  const ImU32 back = on ? theme::accent_dark : ImGui::IsItemHovered() ? theme::pressed : theme::hovered;
  list.AddRectFilled({corner.x, middle - radius}, {corner.x + track, middle + radius}, back, radius);
  list.AddCircleFilled({on ? corner.x + track - radius : corner.x + radius, middle}, radius - scaled(2.5f),
                       on ? theme::text : theme::quiet, 24);
  list.AddText({corner.x + track + scaled(10), middle - ImGui::GetFontSize() / 2}, theme::text, say(words).c_str());
  return pressed;
}

bool slider(const char* words, double& value, double low, double high, const char* format) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight(), height = line + scaled(18);
  area(words, {width, height});
  const bool held = ImGui::IsItemActive() && ImGui::GetCurrentContext()->ActiveIdSource == ImGuiInputSource_Mouse,
             keyed = keyboard_here();
  const bool near = ImGui::IsItemHovered() || held || keyed;
  const float radius = scaled(7), left = corner.x + radius - scaled(2), right = corner.x + width - radius + scaled(2);
  bool changed = false;
  if (held) {
    const double share = std::clamp((ImGui::GetIO().MousePos.x - left) / (right - left), 0.0f, 1.0f);
    const double wanted = low + share * (high - low);
    changed = wanted != value;
    value = wanted;
  }
  if (keyed) {
    const double wanted = moved_by_keys(value, low, high, format);
    changed = changed || wanted != value;
    value = wanted;
  }
  const float share = static_cast<float>(std::clamp((value - low) / (high - low), 0.0, 1.0));
  const float middle = corner.y + line + scaled(9), knob = left + share * (right - left);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(corner, theme::text, say(words).c_str());
  char formatted[64];
  std::snprintf(formatted, sizeof formatted, format, value);
  const std::string number = interface_now().language().localised(formatted);
  expect_room(say(words) + number, width - scaled(8));
  list.AddText({corner.x + width - ImGui::CalcTextSize(number.c_str()).x, corner.y}, theme::quiet, number.c_str());
  list.AddRectFilled({left, middle - scaled(2)}, {right, middle + scaled(2)}, theme::hovered, scaled(2));
  list.AddRectFilled({left, middle - scaled(2)}, {knob, middle + scaled(2)}, theme::accent, scaled(2));
  list.AddCircleFilled({knob, middle}, near ? radius : radius - scaled(1), near ? theme::text : theme::accent, 24);
  return changed;
}

bool eye(const char* id, bool& open) {
  const float size = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool pressed = area(id, {size, size});
  if (pressed) open = !open;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::IsItemHovered() ? theme::accent : open ? theme::text : theme::quiet;
  const ImVec2 middle(corner.x + size / 2, corner.y + size / 2);
  const float half = scaled(8), lift = scaled(7);
  const ImVec2 left(middle.x - half, middle.y), right(middle.x + half, middle.y);
  list.AddBezierQuadratic(left, {middle.x, middle.y + lift * (open ? 1.2f : 1)}, right, colour, scaled(1.5f), 16);
  if (open) {
    list.AddBezierQuadratic(left, {middle.x, middle.y - lift * 1.2f}, right, colour, scaled(1.5f), 16);
    list.AddCircleFilled(middle, scaled(2.6f), colour, 16);
  } else {
    for (const float x : {-0.5f, 0.0f, 0.5f})
      list.AddLine({middle.x + x * half, middle.y + lift * 0.5f},
                   {middle.x + 1.25f * x * half, middle.y + lift * 0.95f}, colour, scaled(1.4f));
  }
  return pressed;
}

bool swatch(const char* id, std::array<float, 3>& colour) {
  ImGui::PushID(id);
  const float size = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (area("swatch", {size, size})) ImGui::OpenPopup("picker");
  const float inset = scaled(5);
  const ImU32 fill = ImGui::ColorConvertFloat4ToU32({colour[0], colour[1], colour[2], 1});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({corner.x + inset, corner.y + inset}, {corner.x + size - inset, corner.y + size - inset}, fill,
                     scaled(4));
  if (ImGui::IsItemHovered())
    list.AddRect({corner.x + inset, corner.y + inset}, {corner.x + size - inset, corner.y + size - inset}, theme::text,
                 scaled(4), 0, scaled(1.5f));
  bool changed = false;
  if (ImGui::BeginPopup("picker")) {
    ImGui::SetNextItemWidth(scaled(200));
    changed = ImGui::ColorPicker3(
        "##colour", colour.data(),
        ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel);
    ImGui::EndPopup();
  }
  ImGui::PopID();
  return changed;
}

bool button(const char* words, const ImVec2& size) {
  const std::string label(words), seen = say(label.substr(0, label.find("##")));
  const bool pressed =
      ImGui::Button(seen == label ? words : (seen + "###" + label).c_str(), size);  // known by its English words
  note_place(ImGui::GetItemID(), false);
  if (size.x > 0) expect_room(seen, size.x);
  return pressed;
}

void text_field(const char* id) {
  if (interface_now().takes_letters(ImGui::GetID(id))) ImGui::SetKeyboardFocusHere();
}

void noted(const char* id, Field field) { note_place(ImGui::GetID(id), field == Field::text); }

bool wide_button(const char* words, Emphasis emphasis) {
  const bool strong = emphasis == Emphasis::strong;
  const std::string seen = say(words);
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  expect_room(seen, width);
  const ImVec2 corner = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(seen.c_str());
  const bool pressed = area(words, {width, height});
  const bool near = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  const ImU32 calm = strong ? theme::accent_dark : theme::raised, lit = strong ? theme::rgb(0x358792) : theme::hovered;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height},
                     held   ? theme::pressed
                     : near ? lit
                            : calm,
                     scaled(6));
  list.AddText({corner.x + 0.5f * (width - size.x), corner.y + 0.5f * (height - size.y)}, theme::text, seen.c_str());
  return pressed;
}

void marked(const Interface&, Mark mark, const std::string& words) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight(), s = scaled(4.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle(corner.x + scaled(6), corner.y + line / 2);
  if (mark == Mark::good) {
    const ImVec2 tick[] = {
        {middle.x - s, middle.y}, {middle.x - s * 0.2f, middle.y + s * 0.8f}, {middle.x + s, middle.y - s * 0.8f}};
    list.AddPolyline(tick, 3, theme::good, 0, scaled(2));
  } else if (mark == Mark::look) {
    list.AddLine({middle.x, middle.y - s * 1.2f}, {middle.x, middle.y + s * 0.3f}, theme::amber, scaled(2.4f));
    list.AddCircleFilled({middle.x, middle.y + s * 1.1f}, scaled(1.5f), theme::amber, 12);
  } else {
    list.AddLine({middle.x - s, middle.y - s}, {middle.x + s, middle.y + s}, theme::bad, scaled(2));
    list.AddLine({middle.x - s, middle.y + s}, {middle.x + s, middle.y - s}, theme::bad, scaled(2));
  }
  ImGui::SetCursorScreenPos({corner.x + scaled(20), corner.y});
  wrapped(words);
}

bool marked_button(const char* id, Mark mark, const std::string& words) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, inset = scaled(4);
  const ImVec2 text = ImGui::CalcTextSize(say(words).c_str(), nullptr, false, width - scaled(20) - inset);
  const float height = text.y + 2 * inset;
  const bool pressed = area(id, {width, height});
  const bool near = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + width, corner.y + height},
                                            held   ? theme::pressed
                                            : near ? theme::hovered
                                                   : theme::raised,
                                            scaled(4));
  ImGui::SetCursorScreenPos({corner.x + inset, corner.y + inset});
  marked(interface_now(), mark, words);
  ImGui::SetCursorScreenPos(below);
  return pressed;
}

}  // namespace odontoscope::widgets
