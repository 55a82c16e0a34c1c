#include "engine/viewer/modes.h"

#include <algorithm>

#include "engine/viewer/compare/compare_mode.h"
#include "engine/viewer/fly/fly_mode.h"
#include "engine/viewer/help/help_mode.h"
#include "engine/viewer/load/load_mode.h"
#include "engine/viewer/look/look_mode.h"
#include "engine/viewer/measure/measure_mode.h"
#include "engine/viewer/names/names_mode.h"
#include "engine/viewer/notes/notes_mode.h"
#include "engine/viewer/open/open_mode.h"
#include "engine/viewer/save/save_mode.h"
#include "engine/viewer/volume/volume_mode.h"
#include "engine/viewer/workspace.h"

namespace odontoscope {

/// Who comes first is asked first, and drawn on top. A new mode is one line.
std::vector<ModeMaker> standard_modes() {
  return {
      mode<LoadMode>,     // a model in the making, and what went wrong
      mode<NotesMode>,    // lessons, quizzes and a teacher's notes
      mode<OpenMode>,     // files to choose from, and the question that a volume raises
      mode<HelpMode>,     // the list of keys, and hints for the first run
      mode<FlyMode>,      // inside the pulp and around the tooth, and rides along canals
      mode<MeasureMode>,  // distances and walls
      mode<NamesMode>,    // structures and canals pointed at from outside
      mode<CompareMode>,  // DB beside DT
      mode<VolumeMode>,   // grey values and films
      mode<SaveMode>,     // pictures and scenes
      mode<LookMode>,     // turning, the section, the compass: what is left to all
  };
}

Modes::Modes(Workspace& workspace, const std::vector<ModeMaker>& makers) {
  for (const ModeMaker make : makers) all_.push_back(make(workspace));
}

ModeEffects Modes::effects() const {
  ModeEffects all;
  for (const auto& one : all_) {
    const ModeEffects its = one->effects();
    all.from_outside &= its.from_outside;
    all.names &= its.names;
    all.section_handle &= its.section_handle;
    all.first_hints &= its.first_hints;
    all.remember_looks &= its.remember_looks;
    all.shadows_while_moving &= its.shadows_while_moving;
  }
  return all;
}

bool Modes::any(bool (Mode::*asked)() const) const {
  return std::any_of(begin(), end(), [&](const auto& one) { return (*one.*asked)(); });
}

std::optional<Grip> Modes::grip_at(const Hover& hover) const {
  for (const auto& one : all_)
    if (const auto part = one->grip_at(hover)) return Grip{one.get(), *part};
  return std::nullopt;
}

std::string Modes::click_hint() const {
  for (const auto& one : all_)
    if (std::string its = one->click_hint(); !its.empty()) return its;
  return {};
}

const OtherModel* Modes::other_model() const {
  for (const auto& one : all_)
    if (const OtherModel* other = one->other_model()) return other;
  return nullptr;
}

const KeyTable& Modes::keys() const {
  for (const auto& one : all_)
    if (const KeyTable* its = one->keys()) return *its;
  return usual_keys();
}

Mode::Mode(Workspace& workspace) : at_(workspace), state_(workspace.state) {}

void Mode::notice(std::string words, NoticeKind kind, double seconds) { at_.notice(std::move(words), kind, seconds); }

}  // namespace odontoscope
