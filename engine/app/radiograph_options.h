#pragma once
// render --radiograph: how it is told on the command line, and made. Needs no OpenGL.

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/dt_options.h"
#include "engine/app/scene_words.h"
#include "engine/app/shown_input.h"
#include "engine/app/volume_look_words.h"
#include "engine/app/volume_options.h"
#include "engine/picture/image.h"
#include "engine/scene/camera.h"

namespace odontoscope::app {

/// As typed; not yet understood.
struct RadiographWords {
  bool on = false;
  double kv = 70;
  std::string beam;             // "cone", "parallel"; empty: cone
  std::optional<double> focus;  // mm from focus to film
  std::string tube;             // "H,V" degrees
  std::string film;             // "WxH" mm
  std::optional<double> pixel;  // mm
  std::optional<double> exposure;
  bool inverted = false;
  std::vector<std::string> attenuation;  // "NAME=MU" or "NAME=TISSUE"
  std::string grey;                      // "AIR,DENTINE"

  /// Is any but `on` told?
  bool any() const;
};

void add_radiograph_options(CLI::App& parser, RadiographWords& words);

/// Throws UsageError for words that make no sense whatever the input, and for words about a radiograph where none is
/// asked for.
void refuse_senseless(const RadiographWords& words);

/// UsageError for words about pictures: a film has mm instead of pixels, and no looks.
void refuse_words_about_pictures(const SceneWords& scene, const VolumeLookWords& look);

/// How the tube stands to it, and what is left out.
struct RadiographPose {
  NamedView view = NamedView::buccal;      // where the tube stands
  const std::vector<std::string>& hidden;  // solids
  int turns = 1;                           // films from so many sides all around
};

/// Takes one film after the other: of many at once the pixels would fill the memory.
using TakeFilm = std::function<void(Image&& film)>;

/// Through solids, and tells how. `file` is for messages. InputError open-surface or misoriented-surface for solids of
/// a mesh that do not say where material is; UsageError for a structure that no tissue is known for.
void radiographs(const RadiographWords& words, const Shown& shown, const std::string& file, const RadiographPose& pose,
                 Session& session, const TakeFilm& take);

/// Through the voxels of a volume called `file`, and tells how. UsageError for words about solids, and for a label map
/// without --grey.
void radiographs(const RadiographWords& words, const Volume& volume, const std::string& file,
                 const RadiographPose& pose, Session& session, const TakeFilm& take);

struct RadiographInput {
  const std::string& file;  // empty: the sample molar
  const VolumeWords& volume;
  const DtWords& dt;
};

/// Of a file: a volume with no word on its surfaces is shone through voxel by voxel, anything else through its solids.
/// Throws as the readers and the engine do, too.
void radiographs(const RadiographWords& words, const RadiographInput& input, const RadiographPose& pose,
                 Session& session, const TakeFilm& take);

}  // namespace odontoscope::app
