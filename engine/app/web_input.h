#pragma once
// What a web page shows: one model, or the same contours by two methods.

#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/db_options.h"
#include "engine/app/dt_options.h"
#include "engine/app/volume_look_words.h"
#include "engine/app/volume_options.h"
#include "engine/web/page.h"

namespace odontoscope::app {

struct WebWords {
  std::string input;  // empty: the sample molar
  VolumeWords volume;
  bool with_db = false;
  DtWords dt;
  DbWords db;
  std::optional<int> triangles;  // at most, of DT's surfaces
  VolumeLookWords look;          // of grey values
  std::string grey;              // of --grey

  bool with_volume() const { return !look.show.empty() && look.show != "surfaces"; }
  bool alone() const;  // grey values, and nothing says where a surface lies
};

/// UsageError for words that make no sense together.
void refuse_senseless(const WebWords& words);

/// Everything but the title. A contour stack or volume is reconstructed; a mesh is taken as it is. Throws as the
/// readers and engines do.
WebPage web_page_of(const WebWords& words, Session& session);

}  // namespace odontoscope::app
