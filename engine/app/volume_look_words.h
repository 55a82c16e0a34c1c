#pragma once
// How a volume's grey values are shown, as told on the command line.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/shown_input.h"
#include "engine/scene/scene.h"
#include "recon/radiograph/grey_anchors.h"
#include "recon/radiograph/tissue.h"

namespace odontoscope::app {

/// As typed; not yet understood.
struct VolumeLookWords {
  std::string show, cast, transfer;
  std::string slopes = {};
  bool any_of_volume() const { return !cast.empty() || !transfer.empty() || !slopes.empty(); }
};

void add_volume_look_options(CLI::App& parser, VolumeLookWords& words);

void add_grey_option(CLI::App& parser, std::string& grey);

/// "20,150"; nothing for an empty text. UsageError for anything else, or unless the first is less.
std::optional<GreyAnchors> greys_from(const std::string& text);

/// Throws UsageError for words that make no sense whatever the input.
void refuse_senseless(const VolumeLookWords& words);

struct VolumeLookRequest {
  const VolumeLookWords& words;
  const std::string& grey;  // of --grey
  double kv = 70;
  const std::vector<std::string>& opacities;  // "S=F", as typed: what was told stays
  bool background_told = false;
};

/// Are grey values wanted, by the words or else by the scene file (may be empty)? Throws as read_scene does.
bool wants_voxels(const VolumeLookWords& words, const std::string& scene_file);

/// Changes the scene as told, and tells how values are read. Structures become clear before a volume that lies within
/// them. UsageError if grey values are to be shown and the input has none.
void show_volume(const VolumeLookRequest& request, const Shown& shown, Scene& scene, Session& session);

}  // namespace odontoscope::app
