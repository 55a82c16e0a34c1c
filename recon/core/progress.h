#pragma once
// How long work tells how far it is, and how it is told to stop. Passed by const reference; copying is cheap.

#include <functional>
#include <stop_token>
#include <string_view>

#include "recon/core/error.h"

namespace odontoscope {

struct Progress {
  /// Called with the name of the running stage ("triangulate") and how much of it is done, 0 to 1. May be called from
  /// any thread, one call at a time per stage; must be quick. Empty: nobody listens.
  std::function<void(std::string_view stage, double fraction)> report;
  /// Request a stop on its source to cancel; the work throws Cancelled soon after.
  std::stop_token stop;

  void tell(std::string_view stage, double fraction) const {
    if (report) report(stage, fraction);
  }
  /// Throws Cancelled once a stop was requested.
  void check() const {
    if (stop.stop_requested()) throw Cancelled{};
  }
};

}  // namespace odontoscope
