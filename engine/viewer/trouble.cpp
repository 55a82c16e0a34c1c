#include "engine/viewer/trouble.h"

#include <imgui.h>

#include <exception>
#include <new>

#include "engine/ui/theme.h"
#include "engine/ui/widgets.h"
#include "recon/core/error.h"

namespace odontoscope {

std::string words_for_current_exception() {
  try {
    throw;
  } catch (const Error& error) {
    return error.what();
  } catch (const std::bad_alloc&) {
    return "This machine has not enough memory for that. Make it smaller: fewer slices, or a larger smallest contour.";
  } catch (const std::exception& error) {
    return InternalError(error.what()).what();
  }
}

void draw_trouble(const Interface& interface, const std::string& words) {
  const ErrorWords* known = interface.language().words_for_error(words);
  if (!known) {
    widgets::wrapped(words);
    return;
  }
  widgets::as_written(interface.say("This rule is broken:") + " " + known->rule);
  widgets::as_written(known->remedy);
  ImGui::Dummy({0, widgets::scaled(2)});
  ImGui::PushStyleColor(ImGuiCol_Text, theme::quiet);
  widgets::as_written(interface.say("Precisely, in English:") + " " + words);
  ImGui::PopStyleColor();
}

}  // namespace odontoscope
