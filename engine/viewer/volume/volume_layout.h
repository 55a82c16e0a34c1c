#pragma once
// What the panel's controls of a volume were set to, and what they ask for.

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/scene/scene.h"

namespace odontoscope {

/// What the transfer function was laid out by.
struct VolumeLayout {
  TransferPreset preset = TransferPreset::tooth;
  double air = 0, dentine = 1, density = 1;
  std::vector<TransferPoint> edited = {};  // at density 1; none: as the preset has it
  std::size_t chosen = 0;                  // of the transfer function's points
  double data = 0.85;                      // from the surfaces alone, 0, to the volume alone, 1
};

/// Done in the next frame.
struct VolumeAsked {
  bool film = false;           // another film was chosen: the camera goes where all of it is seen
  std::optional<double> tube;  // degrees to the right of buccal, from where an X-ray tube would look
  /// Of a model whose deviations are not known yet: they are measured meanwhile.
  std::optional<DataColours::Of> data_colours;
};

}  // namespace odontoscope
