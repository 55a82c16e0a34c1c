#include "engine/ui/theme.h"

namespace odontoscope::theme {

void apply(ImGuiStyle& style, float scale) {
  style = ImGuiStyle();
  style.WindowPadding = {16, 12};
  style.FramePadding = {10, 6};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {8, 6};
  style.WindowRounding = 8;
  style.ChildRounding = 6;
  style.FrameRounding = 6;
  style.GrabRounding = 6;
  style.PopupRounding = 8;
  style.ScrollbarRounding = 6;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 14;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.DisabledAlpha = 0.4f;
  style.AntiAliasedLinesUseTex = false;
  style.ScaleAllSizes(scale);
  style.PopupBorderSize = 1;

  const auto set = [&style](ImGuiCol which, ImU32 colour) {
    style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  ImGui::StyleColorsDark(&style);
  set(ImGuiCol_Text, text);
  set(ImGuiCol_TextDisabled, quiet);
  set(ImGuiCol_WindowBg, panel);
  set(ImGuiCol_ChildBg, 0);
  set(ImGuiCol_PopupBg, raised);
  set(ImGuiCol_Border, line);
  set(ImGuiCol_FrameBg, raised);
  set(ImGuiCol_FrameBgHovered, hovered);
  set(ImGuiCol_FrameBgActive, pressed);
  set(ImGuiCol_ScrollbarBg, 0);
  set(ImGuiCol_ScrollbarGrab, hovered);
  set(ImGuiCol_ScrollbarGrabHovered, pressed);
  set(ImGuiCol_ScrollbarGrabActive, pressed);
  set(ImGuiCol_CheckMark, accent);
  set(ImGuiCol_SliderGrab, accent);
  set(ImGuiCol_SliderGrabActive, text);
  set(ImGuiCol_Button, raised);
  set(ImGuiCol_ButtonHovered, hovered);
  set(ImGuiCol_ButtonActive, pressed);
  set(ImGuiCol_Header, raised);
  set(ImGuiCol_HeaderHovered, hovered);
  set(ImGuiCol_HeaderActive, pressed);
  set(ImGuiCol_Separator, line);
  set(ImGuiCol_TextSelectedBg, accent_dark);
  set(ImGuiCol_PlotHistogram, accent);
  set(ImGuiCol_NavHighlight, accent);
  set(ImGuiCol_ModalWindowDimBg, rgb(0x0b0d0f, 150));
}

}  // namespace odontoscope::theme
