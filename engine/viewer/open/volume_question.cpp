#include "engine/viewer/open/volume_question.h"

#include <algorithm>
#include <utility>

namespace odontoscope {

void take_preview(VolumeQuestion& question, VolumePreview preview) {
  question.reading = false;
  question.series = std::move(preview.series);
  if (!question.series.empty()) return;
  if (!question.iso_said && !preview.thresholds.empty()) question.iso = preview.thresholds.front();
  for (const VolumePreview::Label& label : preview.labels) question.labels.insert(label.value);
  constexpr double any_label = 0.5;
  question.slice = fullest_slice(preview.values, preview.labels.empty() ? question.iso : any_label);
  question.preview = std::make_shared<const VolumePreview>(std::move(preview));
}

void draw_anew(VolumeQuestion& question) {
  if (!question.preview) return;
  const VolumePreview& preview = *question.preview;
  VolumeQuestion::Drawn& drawn = question.drawn;
  const bool other_slice = drawn.pictures == 0 || drawn.slice != question.slice || drawn.as_grey != question.as_grey;
  if (!other_slice && drawn.iso == question.iso && drawn.labels == question.labels) return;
  if (other_slice) {
    drawn.picture = slice_picture(preview.values, question.slice,
                                  question.of_labels() ? preview.values.range : preview.values.usual);
    ++drawn.pictures;
  }
  drawn.slice = question.slice;
  drawn.iso = question.iso;
  drawn.labels = question.labels;
  drawn.as_grey = question.as_grey;
  drawn.outline = question.of_labels() ? label_outline(preview.values, question.slice, question.labels)
                                       : slice_outline(preview.values, question.slice, question.iso);
}

LoadRequest about_series(const VolumeQuestion& question, std::size_t place) {
  LoadRequest request = question.request;
  request.series = std::to_string(place + 1);
  return request;
}

LoadRequest answer_of(const VolumeQuestion& question) {
  LoadRequest request = question.request;
  request.volume = VolumeChoice{.iso = {}, .labels = {}, .min_area_pixels = std::max(question.min_area_pixels, 0.0)};
  if (question.of_labels())
    request.volume->labels.assign(question.labels.begin(), question.labels.end());
  else
    request.volume->iso = question.iso;
  return request;
}

}  // namespace odontoscope
