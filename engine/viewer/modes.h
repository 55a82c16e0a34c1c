#pragma once
// The modes of a viewer, in the order in which they are asked.

#include <memory>
#include <typeinfo>
#include <vector>

#include "engine/viewer/mode.h"
#include "recon/core/error.h"

namespace odontoscope {

using ModeMaker = std::unique_ptr<Mode> (*)(Workspace&);
template <class M>
std::unique_ptr<Mode> mode(Workspace& workspace) {
  return std::make_unique<M>(workspace);
}

/// Those that the program has: modes.cpp lists them.
std::vector<ModeMaker> standard_modes();

class Modes {
 public:
  Modes(Workspace& workspace, const std::vector<ModeMaker>& makers);

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  auto rbegin() const { return all_.rbegin(); }
  auto rend() const { return all_.rend(); }

  /// What all that are on change together.
  ModeEffects effects() const;
  bool any(bool (Mode::*asked)() const) const;
  bool dialog_open() const { return any(&Mode::dialog_open); }
  bool writing() const { return any(&Mode::writing); }
  bool loading() const { return any(&Mode::loading); }
  std::optional<Grip> grip_at(const Hover& hover) const;
  /// What a click in the picture is for, in words; empty: nothing in particular.
  std::string click_hint() const;
  /// Null: none of them has one.
  const OtherModel* other_model() const;
  /// The keys that count now.
  const KeyTable& keys() const;

  /// For modes that build on another, and for tests.
  template <class M>
  M& get() const {
    for (const auto& one : all_)
      if (auto* found = dynamic_cast<M*>(one.get())) return *found;
    throw InternalError(std::string("there is no ") + typeid(M).name());
  }

 private:
  std::vector<std::unique_ptr<Mode>> all_;
};

}  // namespace odontoscope
