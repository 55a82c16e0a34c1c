#include "recon/volume/dicom_segmentation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/input/character_set.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_stack.h"
#include "recon/volume/limits.h"
#include "recon/volume/pixel_file.h"

namespace odontoscope {
namespace {

constexpr std::uint32_t largest_number = 65535;
constexpr std::string_view export_it = "export it as a label map (NRRD or NIfTI)";

[[noreturn]] void refuse(std::string_view cause, const DicomImage& image, const std::string& wrong,
                         std::string_view remedy = export_it) {
  throw InputError(cause, in_file(image.file.path), wrong, remedy);
}

/// In UTF-8, without control characters, as long as names may be.
std::string name_of(const DicomImage& image, const DicomDataSet& segment) {
  std::string name = to_utf8(segment.text(dicom::segment_label).substr(0, limits::name_length),
                             image.file.data.text(dicom::character_set))
                         .utf8;
  while (name.size() > limits::name_length) {  // a character at a time
    do name.pop_back();
    while (!name.empty() && (static_cast<unsigned char>(name.back()) & 0xc0) == 0x80);
  }
  return name;
}

std::vector<VolumeLabel> labels_of(const DicomImage& image) {
  std::vector<VolumeLabel> labels;
  const DicomElement* segments = image.file.data.find(dicom::segments);
  if (segments == nullptr) return labels;
  if (segments->items.size() > limits::structures) {
    refuse("too-many-structures", image,
           fmt::format("it has {} segments; the limit is {}", segments->items.size(), limits::structures),
           "leave out those that are not needed");
  }
  std::set<std::int64_t> seen;
  for (const DicomDataSet& item : segments->items) {
    const double number = item.number(dicom::segment_number).value_or(0);
    if (!(number >= 1 && number <= largest_number))
      refuse("unreadable-volume", image, "one of its segments has no number");
    const auto value = static_cast<std::int64_t>(number);
    if (!seen.insert(value).second)
      refuse("unreadable-volume", image, fmt::format("two of its segments have the number {}", value));
    if (std::string name = name_of(image, item); !name.empty()) labels.push_back({value, std::move(name)});
  }
  return labels;
}

/// Values for voxels that are of several segments.
class Overlaps {
 public:
  Overlaps(const DicomImage& image, std::int64_t first_free) : image_(image), next_(first_free) {}

  /// What a voxel of value `before` becomes when it is of `segment`, too.
  std::int64_t joined(std::int64_t before, std::int64_t segment) {
    if (before == 0 || before == segment) return segment;
    const auto [known, is_new] = joined_.try_emplace({before, segment}, 0);
    if (is_new) known->second = value_of(before, segment);
    return known->second;
  }

  std::vector<LabelOverlap> take() { return std::move(found_); }

 private:
  std::int64_t value_of(std::int64_t before, std::int64_t segment) {
    const auto own =
        std::find_if(found_.begin(), found_.end(), [before](const LabelOverlap& o) { return o.value == before; });
    std::vector<std::int64_t> labels = own == found_.end() ? std::vector{before} : own->labels;
    if (std::find(labels.begin(), labels.end(), segment) != labels.end()) return before;
    labels.insert(std::upper_bound(labels.begin(), labels.end(), segment), segment);
    const auto same =
        std::find_if(found_.begin(), found_.end(), [&labels](const LabelOverlap& o) { return o.labels == labels; });
    if (same != found_.end()) return same->value;
    if (found_.size() == limits::label_overlaps) {
      refuse("too-many-structures", image_,
             fmt::format("its segments overlap in more than {} ways", limits::label_overlaps),
             "leave out segments that are not needed");
    }
    found_.push_back({next_, std::move(labels)});
    return next_++;
  }

  const DicomImage& image_;
  std::int64_t next_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> joined_;
  std::vector<LabelOverlap> found_;
};

class Reading {
 public:
  Reading(const DicomImage& image, const std::string& source, const ReadVolumeOptions& options,
          const Progress& progress)
      : image_(image),
        source_(source),
        options_(options),
        progress_(progress),
        kind_(image.file.data.text(dicom::segmentation_type)),
        labels_(labels_of(image)) {}

  Volume run() {
    check_segments();
    check_alike();
    find_heights();
    find_step();
    DicomImage whole = evenly_spaced();
    DicomStack stack = stack_planes({&whole}, source_, options_);
    oriented_grid(stack.image);  // throws what is wrong with it before memory is asked for
    check_memory(source_, stack.image.size[0] * stack.image.size[1] * stack.image.size[2]);
    stack.image.values = values();
    Volume volume = oriented(std::move(stack.image));
    volume.labels = std::move(labels_);
    std::stable_sort(volume.labels.begin(), volume.labels.end(),
                     [](const VolumeLabel& a, const VolumeLabel& b) { return a.value < b.value; });
    volume.overlaps = std::move(overlaps_);
    volume.remarks = std::move(stack.remarks);
    volume.remarks.insert(volume.remarks.end(), remarks_.begin(), remarks_.end());
    return volume;
  }

 private:
  const std::vector<DicomFrame>& frames() const { return image_.frames; }
  bool of_numbers() const { return kind_ == "LABELMAP"; }

  void check_segments() const {
    if (of_numbers()) return;
    for (std::size_t n = 0; n < frames().size(); ++n)
      if (frames()[n].segment == 0)
        refuse("unreadable-volume", image_, fmt::format("its frame {} does not say which segment it is of", n + 1));
  }

  void check_alike() {
    const DicomFrame& first = frames().front();
    for (std::size_t n = 0; n < frames().size(); ++n) {
      const DicomFrame& frame = frames()[n];
      bool alike = frame.orientation.has_value() == first.orientation.has_value() &&
                   frame.spacing.has_value() == first.spacing.has_value();
      for (std::size_t axis = 0; alike && axis < 2; ++axis) {
        for (std::size_t x = 0; frame.orientation && x < 3; ++x)
          alike = alike &&
                  std::abs((*frame.orientation)[axis][x] - (*first.orientation)[axis][x]) <= limits::axes_out_of_square;
        if (frame.spacing)
          alike = alike && std::abs((*frame.spacing)[axis] - (*first.spacing)[axis]) <=
                               limits::slice_unevenness * (*first.spacing)[axis];
      }
      if (!alike)
        refuse("mixed-series", image_,
               fmt::format("the orientation or pixel spacing of its frame {} differs from that of the first", n + 1));
    }
    normal_ = first.orientation ? cross((*first.orientation)[0], (*first.orientation)[1]) : Vector3{0, 0, 1};
  }

  /// Frames from below, and for each the number of its plane; planes' heights from the lowest on, and their first
  /// frames.
  void find_heights() {
    order_.resize(frames().size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::vector<double> heights;
    for (const DicomFrame& frame : frames()) heights.push_back(dot(*frame.position, normal_));
    std::stable_sort(order_.begin(), order_.end(),
                     [&heights](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
    plane_.resize(frames().size());
    const double lowest = heights[order_.front()];
    for (const std::size_t n : order_) {
      if (heights_.empty() || heights[n] - lowest - heights_.back() > limits::one_plane) {
        heights_.push_back(heights[n] - lowest);
        first_in_.push_back(n);
      }
      plane_[n] = heights_.size() - 1;
      check_beside(frames()[n], frames()[first_in_.back()]);
    }
    if (heights_.size() < 2)
      refuse("single-slice", image_, "all its segments lie in one slice",
             "give at least two slices; a solid lies between them");
  }

  /// Frames of one plane have their first pixel in one place.
  void check_beside(const DicomFrame& frame, const DicomFrame& first) const {
    double squared = 0;
    for (std::size_t x = 0; x < 3; ++x) squared += portable::square((*frame.position)[x] - (*first.position)[x]);
    const double allowed = first.spacing
                               ? std::max(limits::slice_unevenness * std::min((*first.spacing)[0], (*first.spacing)[1]),
                                          2 * limits::one_plane)
                               : 2 * limits::one_plane;
    if (std::sqrt(squared) <= allowed) return;
    refuse("sheared-volume", image_,
           "frames of one slice lie beside each other: it is made of tiles, or of several images");
  }

  /// How many steps of `step` each plane lies above the lowest; nothing if planes fit no such steps.
  std::optional<std::vector<std::size_t>> steps_of(double step) const {
    std::vector<std::size_t> steps{0};
    for (std::size_t k = 1; k < heights_.size(); ++k) {
      const double count = std::round((heights_[k] - heights_[k - 1]) / step);
      if (!(count >= 1) || !(count + static_cast<double>(steps.back()) < static_cast<double>(limits::slices)))
        return std::nullopt;
      steps.push_back(steps.back() + static_cast<std::size_t>(count));
    }
    const double fitted = heights_.back() / static_cast<double>(steps.back());
    const double rounding =
        image_.position_grain / 2 * (std::abs(normal_[0]) + std::abs(normal_[1]) + std::abs(normal_[2]));
    const double allowed =
        std::max(limits::slice_unevenness * fitted, std::min(2 * rounding, limits::slice_rounding * fitted));
    for (std::size_t k = 0; k < heights_.size(); ++k)
      if (std::abs(heights_[k] - fitted * static_cast<double>(steps[k])) > allowed) return std::nullopt;
    return steps;
  }

  void find_step() {
    double least = heights_.back();
    for (std::size_t k = 1; k < heights_.size(); ++k) least = std::min(least, heights_[k] - heights_[k - 1]);
    const double told = std::abs(frames().front().slice_spacing.value_or(0));
    std::optional<std::vector<std::size_t>> steps;
    if (told > 0) steps = steps_of(told);
    if (!steps) steps = steps_of(least);
    if (!steps) {
      refuse("uneven-slices", image_,
             fmt::format(
                 "its frames lie {:.4g} mm apart and more, and not at multiples of one distance, nor within {} slices",
                 least, limits::slices));
    }
    std::size_t common = 0;
    for (const std::size_t n : *steps) common = std::gcd(common, n);
    for (std::size_t& n : *steps) n /= common;
    steps_ = std::move(*steps);
    step_ = heights_.back() / static_cast<double>(steps_.back());
    if (told > 0 && std::abs(step_ - told) > limits::slice_unevenness * told) {
      remarks_.push_back(
          fmt::format("its frames lie {:.4g} mm apart, although it says that slices do by {:.4g} mm", step_, told));
    }
    const std::size_t empty = steps_.back() + 1 - steps_.size();
    if (empty > 0)
      remarks_.push_back(fmt::format("{} {} between its frames have none: no segment is there", empty,
                                     empty == 1 ? "slice" : "slices"));
  }

  /// An image with one frame for each slice, where it lies or would.
  DicomImage evenly_spaced() const {
    DicomImage whole;
    whole.file.path = image_.file.path;
    whole.rows = image_.rows;
    whole.columns = image_.columns;
    whole.position_grain = image_.position_grain;
    const DicomFrame& lowest = frames()[first_in_.front()];
    std::size_t plane = 0;
    for (std::size_t k = 0; k <= steps_.back(); ++k) {
      if (steps_[plane] == k) {
        whole.frames.push_back(frames()[first_in_[plane++]]);
        continue;
      }
      whole.frames.push_back(lowest);
      for (std::size_t x = 0; x < 3; ++x)
        whole.frames.back().position->at(x) += step_ * static_cast<double>(k) * normal_[x];
    }
    return whole;
  }

  std::vector<float> values() {
    check_plausible(all_planes());
    const std::size_t pixels = image_.pixels();
    std::vector<float> result(pixels * (steps_.back() + 1));
    std::int64_t last = 0;
    for (const VolumeLabel& label : labels_) last = std::max(last, label.value);
    for (const DicomFrame& frame : frames()) last = std::max<std::int64_t>(last, frame.segment);
    Overlaps overlaps(image_, last + 1);
    // By segment and then from below, so that values do not depend on the order of frames.
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(frames()[a].segment, plane_[a]) < std::pair(frames()[b].segment, plane_[b]);
    });
    for (std::size_t n = 0; n < order_.size(); ++n) {
      if (n > 0 && frames()[order_[n]].segment == frames()[order_[n - 1]].segment &&
          plane_[order_[n]] == plane_[order_[n - 1]])
        refuse_doubled(order_[n - 1], order_[n]);
    }
    std::size_t shared = 0;
    DicomBytes bytes(image_.file);
    for (std::size_t n = 0; n < order_.size(); ++n) {
      progress_.check();
      progress_.tell("read", static_cast<double>(n) / static_cast<double>(order_.size()));
      read_frame(n, bytes);
      add(frames()[order_[n]].segment, result.data() + steps_[plane_[order_[n]]] * pixels, overlaps, shared);
    }
    overlaps_ = overlaps.take();
    if (shared > 0)
      remarks_.push_back(
          fmt::format("{} {} of several segments at once", shared, shared == 1 ? "voxel is" : "voxels are"));
    if (kind_ == "FRACTIONAL")
      remarks_.push_back("its segments are fractional: of each those voxels are taken that are at least half of it");
    return result;
  }

  std::vector<DicomPlane> all_planes() const {
    std::vector<DicomPlane> planes;
    for (std::size_t n = 0; n < frames().size(); ++n) planes.push_back({&image_, n});
    return planes;
  }

  [[noreturn]] void refuse_doubled(std::size_t a, std::size_t b) const {
    refuse("time-series", image_,
           fmt::format("its frames {} and {} are of one segment and lie in one place: it is a series in time",
                       std::min(a, b) + 1, std::max(a, b) + 1),
           "export one moment alone");
  }

  /// The pixels of the n-th frame in order into frame_.
  void read_frame(std::size_t n, DicomBytes& bytes) {
    if (image_.bits_allocated == 1) return read_bits(image_, order_[n], bytes, frame_);
    // Many at once, since compressed ones are decoded in a process of their own, but no more than memory holds.
    constexpr std::size_t batch = 1u << 24;
    const std::size_t pixels = image_.pixels();
    if (n >= batch_end_) {
      std::vector<DicomPlane> planes;
      batch_begin_ = n;
      for (batch_end_ = n; batch_end_ < order_.size() && (batch_end_ == n || (batch_end_ - n + 1) * pixels <= batch);
           ++batch_end_)
        planes.push_back({&image_, order_[batch_end_]});
      batch_ = read_planes(planes, {{}, progress_.stop});
    }
    const auto from = batch_.begin() + static_cast<std::ptrdiff_t>((n - batch_begin_) * pixels);
    frame_.assign(from, from + static_cast<std::ptrdiff_t>(pixels));
  }

  void add(std::int64_t segment, float* to, Overlaps& overlaps, std::size_t& shared) const {
    const double half =
        kind_ == "FRACTIONAL" ? std::max(image_.file.data.number(dicom::fraction_of).value_or(255), 1.0) / 2 : 0.5;
    std::int64_t before = 0, after = segment;  // the last way in which voxels were joined
    for (std::size_t n = 0; n < frame_.size(); ++n) {
      if (of_numbers()) {
        to[n] = frame_[n];
        continue;
      }
      if (!(frame_[n] >= half)) continue;
      const auto value = static_cast<std::int64_t>(to[n]);
      if (value != before) {
        before = value;
        after = overlaps.joined(value, segment);
      }
      if (value != 0) ++shared;
      to[n] = static_cast<float>(after);
    }
  }

  const DicomImage& image_;
  const std::string& source_;
  const ReadVolumeOptions& options_;
  const Progress& progress_;
  std::string kind_;
  std::vector<VolumeLabel> labels_;
  Vector3 normal_{0, 0, 1};
  std::vector<std::size_t> order_, plane_, first_in_, steps_;
  std::vector<double> heights_;
  double step_ = 0;
  std::vector<float> frame_, batch_;
  std::size_t batch_begin_ = 0, batch_end_ = 0;
  std::vector<LabelOverlap> overlaps_;
  std::vector<std::string> remarks_;
};

}  // namespace

Volume dicom_segmentation(const DicomImage& image, const std::string& source, const ReadVolumeOptions& options,
                          const Progress& progress) {
  return Reading(image, source, options, progress).run();
}

std::vector<std::string> segment_names(const DicomImage& image) {
  constexpr std::size_t enough = 12;
  std::vector<std::string> names;
  for (const VolumeLabel& label : labels_of(image)) {
    names.push_back(names.size() == enough ? "..." : fmt::format("{} ({})", label.name, label.value));
    if (names.size() > enough) break;
  }
  return names;
}

}  // namespace odontoscope
