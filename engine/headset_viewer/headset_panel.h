#pragma once
// What stands on the panel in the room: the desktop's controls in fewer words and larger, since a hand's ray is no
// mouse. Called between Interface::begin and end; they change the visit's plain values at once and ask for everything
// else as a VisitAction.

#include <string>

#include "engine/headset/visit.h"
#include "engine/ui/interface.h"
#include "engine/viewer/certificate.h"

namespace odontoscope {

enum class HeadsetPage { tooth, canals, measure, help };

/// What the panel says besides what the visit knows.
struct HeadsetPanelWords {
  std::string title;
  bool db_possible = false;
  std::string db;           // how far DB is, or what is wrong with it
  std::string certificate;  // its headline
  Mark mark = Mark::good;
  bool volume_possible = false;  // the model came from grey values, which can be shown
};

/// In the upper left of the sheet, `width` by `height` pixels.
void draw_headset_panel(Visit& visit, HeadsetPage& page, const VisitWorld& world, const HeadsetPanelWords& words,
                        const Interface& interface, float width, float height);

}  // namespace odontoscope
