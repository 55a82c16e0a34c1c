#pragma once
// The question that a volume raises: where does the surface lie? With what a person looks at to answer it.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <set>
#include <vector>

#include "engine/scene/volume_preview.h"
#include "engine/viewer/loading.h"

namespace odontoscope {

struct VolumeQuestion {
  LoadRequest request = {};                           // that raised it
  std::shared_ptr<const VolumePreview> preview = {};  // null: there is none, or it is still being read
  bool reading = false;
  double read = 0;                       // of it, 0 to 1
  std::vector<SeriesOffer> series = {};  // to choose from before there is anything to see
  double iso = 120;
  bool iso_said = false;  // by the person: a preview leaves it as it is
  double min_area_pixels = 4;
  std::set<std::int64_t> labels = {};  // of a label map: those wanted
  std::size_t slice = 0;

  bool as_grey = false;  // of what looks like a label map: it is none

  bool of_labels() const { return preview && !preview->labels.empty() && !as_grey; }
  bool answered() const { return series.empty() && (!of_labels() || !labels.empty()); }

  /// What of the slice is drawn, and for which answer.
  struct Drawn {
    std::size_t slice = 0;
    double iso = 0;
    std::set<std::int64_t> labels = {};
    bool as_grey = false;
    SlicePicture picture = {};
    int pictures = 0;  // counts up with each
    std::vector<std::array<glm::dvec2, 2>> outline = {};
  } drawn = {};
};

/// Good first answers: Otsu's threshold and the slice that has most above it, or all labels.
void take_preview(VolumeQuestion& question, VolumePreview preview);

/// Makes anew what is drawn if slice or answer are others than it is for.
void draw_anew(VolumeQuestion& question);

/// Asks again, about the series of that place in the list.
LoadRequest about_series(const VolumeQuestion& question, std::size_t place);

/// Precondition: answered().
LoadRequest answer_of(const VolumeQuestion& question);

}  // namespace odontoscope
