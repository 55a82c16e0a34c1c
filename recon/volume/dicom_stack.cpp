#include "recon/volume/dicom_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/portable_math.h"
#include "recon/volume/byte_source.h"

namespace odontoscope {
namespace {

Vector3 minus(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

const DicomFrame& frame_of(const DicomPlane& plane) { return plane.image->frames[plane.frame]; }

/// "IM0003", or "scan.dcm, frame 4" where the file has several; frames count from 1, as in DICOM.
std::string name_of(const DicomPlane& plane) {
  const std::string& file = plane.image->file.path;
  return plane.image->frames.size() == 1 ? file : fmt::format("{}, frame {}", file, plane.frame + 1);
}

class Stacking {
 public:
  Stacking(const std::vector<const DicomImage*>& images, std::string source, const ReadVolumeOptions& options)
      : options_(options) {
    result_.image.source = std::move(source);
    for (const DicomImage* image : images) {
      for (std::size_t frame = 0; frame < image->frames.size(); ++frame) result_.planes.push_back({image, frame});
    }
  }

  DicomStack run() {
    drop_doubles();
    drop_localizers();
    if (planes().size() < 2)
      refuse("single-slice", "it is one image only", "give at least two slices; a solid lies between them");
    if (planes().size() > limits::slices) {
      refuse("too-many-voxels", fmt::format("it has {} slices; the limit is {}", planes().size(), limits::slices),
             "crop it to the tooth");
    }
    check_alike();
    take_plane_geometry();
    if (frame_of(planes().front()).position)
      place_by_positions();
    else
      place_by_numbers();
    if (options_.spacing) result_.image.spacing = *options_.spacing;
    collect_remarks();
    return std::move(result_);
  }

 private:
  std::vector<DicomPlane>& planes() { return result_.planes; }

  [[noreturn]] void refuse(std::string_view cause, const std::string& wrong, std::string_view remedy) const {
    throw InputError(cause, in_file(result_.image.source), wrong, remedy);
  }

  /// The same image twice in a folder is one image. In another place it is another one, whatever its identity: some
  /// programs give all slices one.
  void drop_doubles() {
    std::set<std::tuple<std::string, std::size_t, Vector3>> seen;
    const std::size_t before = planes().size();
    std::erase_if(planes(), [&](const DicomPlane& p) {
      return !p.image->instance.empty() && frame_of(p).position &&
             !seen.emplace(p.image->instance, p.frame, *frame_of(p).position).second;
    });
    if (planes().size() < before)
      result_.remarks.push_back(fmt::format("{} of its images are there twice, with one identity: one of each is taken",
                                            before - planes().size()));
  }

  void drop_localizers() {
    const auto scouts = static_cast<std::size_t>(
        std::count_if(planes().begin(), planes().end(), [](const DicomPlane& p) { return p.image->is_localizer; }));
    if (scouts == 0 || scouts == planes().size()) return;
    std::erase_if(planes(), [](const DicomPlane& p) { return p.image->is_localizer; });
    result_.remarks.push_back(fmt::format("{} of its images are localizers (overviews) and left out", scouts));
  }

  void check_alike() {
    const DicomPlane& first = planes().front();
    for (const DicomPlane& plane : planes()) {
      const char* differs = difference(first, plane);
      if (differs == nullptr) continue;
      throw InputError("mixed-series", in_file(plane.image->file.path),
                       fmt::format("the {} of {} differs from that of {}", differs, name_of(plane), name_of(first)),
                       "put the slices of one volume alone into a folder");
    }
  }

  const char* difference(const DicomPlane& a, const DicomPlane& b) const {
    if (a.image->rows != b.image->rows || a.image->columns != b.image->columns) return "size";
    const DicomFrame &f = frame_of(a), &g = frame_of(b);
    if (f.orientation.has_value() != g.orientation.has_value()) return "orientation";
    for (std::size_t n = 0; f.orientation && n < 2; ++n)
      for (std::size_t x = 0; x < 3; ++x)
        if (std::abs((*f.orientation)[n][x] - (*g.orientation)[n][x]) > limits::axes_out_of_square)
          return "orientation";
    if (f.spacing.has_value() != g.spacing.has_value()) return "pixel spacing";
    for (std::size_t n = 0; f.spacing && n < 2; ++n)
      if (std::abs((*f.spacing)[n] - (*g.spacing)[n]) > limits::slice_unevenness * (*f.spacing)[n])
        return "pixel spacing";
    return f.position.has_value() == g.position.has_value() ? nullptr : "position";
  }

  void take_plane_geometry() {
    FileImage& image = result_.image;
    const DicomFrame& first = frame_of(planes().front());
    image.size = {planes().front().image->columns, planes().front().image->rows, planes().size()};
    if (first.orientation) {
      image.direction[0] = (*first.orientation)[0];
      image.direction[1] = (*first.orientation)[1];
      image.direction[2] = cross(image.direction[0], image.direction[1]);
    } else {
      result_.remarks.push_back(
          "it does not say how its images lie in the patient: they are taken as axial, seen from the feet");
    }
    if (first.spacing) {
      image.spacing[0] = (*first.spacing)[0];
      image.spacing[1] = (*first.spacing)[1];
    } else if (!options_.spacing) {
      refuse("bad-spacing", "it does not say how large its pixels are",
             "give the size of a voxel in mm (--spacing X,Y,Z)");
    }
  }

  double height(const DicomPlane& plane) const {
    return dot(minus(*frame_of(plane).position, *frame_of(result_.planes.front()).position),
               result_.image.direction[2]);
  }

  void place_by_positions() {
    const Vector3 normal = result_.image.direction[2];
    std::stable_sort(planes().begin(), planes().end(), [&normal](const DicomPlane& a, const DicomPlane& b) {
      return dot(*frame_of(a).position, normal) < dot(*frame_of(b).position, normal);
    });
    result_.image.origin = *frame_of(planes().front()).position;
    std::vector<double> heights;
    for (const DicomPlane& plane : planes()) heights.push_back(height(plane));
    check_places(heights);
    fit_spacing(heights);
    check_straight(heights);
  }

  /// How far rounding moves a plane along the normal at most: half of its positions' last digit, in each coordinate.
  double rounding() const {
    double grain = 0;
    for (const DicomPlane& plane : result_.planes) {
      const double own = plane.image->position_grain;
      grain = grain == 0 ? own : own == 0 ? grain : std::min(grain, own);
    }
    const Vector3& normal = result_.image.direction[2];
    return grain / 2 * (std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]));
  }

  double middle_gap(const std::vector<double>& heights) const {
    std::vector<double> gaps;
    for (std::size_t k = 1; k < heights.size(); ++k) gaps.push_back(heights[k] - heights[k - 1]);
    std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
    return gaps[gaps.size() / 2];
  }

  void check_places(const std::vector<double>& heights) const {
    const double middle = middle_gap(heights);
    constexpr double one_place = 0.1;  // of the spacing: far below rounding, far above noise
    for (std::size_t k = 1; k < heights.size(); ++k) {
      if (heights[k] - heights[k - 1] > one_place * middle && heights.back() > 0) continue;
      std::size_t more = k;
      while (more + 1 < heights.size() && heights[more + 1] - heights[k - 1] <= one_place * middle) ++more;
      refuse(
          "time-series",
          fmt::format(
              "{} images lie in one place, {} and {} among them: it is a series in time, or of several kinds of image",
              more - k + 2, name_of(result_.planes[k - 1]), name_of(result_.planes[k])),
          "put the images of one moment and kind alone into a folder");
    }
  }

  struct Line {
    double first = 0, step = 0, worst = 0;
  };
  static Line measured(double first, double step, const std::vector<double>& heights) {
    Line line{first, step, 0};
    for (std::size_t k = 0; k < heights.size(); ++k)
      line.worst = std::max(line.worst, std::abs(heights[k] - first - static_cast<double>(k) * step));
    return line;
  }

  static Line least_squares(const std::vector<double>& heights) {
    const auto n = static_cast<double>(heights.size());
    double sum = 0, weighted = 0;
    for (std::size_t k = 0; k < heights.size(); ++k) {
      sum += heights[k];
      weighted += (static_cast<double>(k) - (n - 1) / 2) * heights[k];
    }
    const double step = weighted * 12 / (n * (n * n - 1));
    return measured(sum / n - step * (n - 1) / 2, step, heights);
  }

  /// The spacing of an even grid, from one end to the other; where rounding explains that slices are off it, the line
  /// that fits all of them best.
  void fit_spacing(const std::vector<double>& heights) {
    const auto gaps = static_cast<double>(heights.size() - 1);
    const Line ends = measured(0, heights.back() / gaps, heights);
    if (ends.worst <= limits::slice_unevenness * ends.step) return take(ends);
    const Line fit = least_squares(heights);
    const double share = options_.spacing ? limits::slice_rounding_by_hand : limits::slice_rounding;
    // A fit to rounded places is off them by a little more than the rounding; gaps between them differ by no more than
    // the last digit, and that is at most half a gap, so that no missing slice passes for it.
    constexpr double more = 1.5;
    const bool rounded = 4 * rounding() <= fit.step && spread(heights) <= 2 * rounding() * (1 + 1e-6) &&
                         fit.worst <= std::min(more * rounding(), share * fit.step);
    const bool by_hand = options_.spacing && fit.worst <= share * fit.step && !has_gap(heights);
    if (!rounded && !by_hand) refuse_uneven(heights, fit);
    result_.remarks.push_back(fmt::format(
        "its slices lie up to {:.2g} mm off even places {:.4g} mm apart, {}", fit.worst, fit.step,
        rounded ? "as rounding of the file's numbers makes" : "which is passed over since the spacing is given"));
    take(fit);
  }

  void take(const Line& line) {
    FileImage& image = result_.image;
    image.spacing[2] = line.step;
    for (std::size_t x = 0; x < 3; ++x) image.origin[x] += line.first * image.direction[2][x];
  }

  /// The widest gap less the narrowest.
  static double spread(const std::vector<double>& heights) {
    double widest = 0, narrowest = heights.back();
    for (std::size_t k = 1; k < heights.size(); ++k) {
      widest = std::max(widest, heights[k] - heights[k - 1]);
      narrowest = std::min(narrowest, heights[k] - heights[k - 1]);
    }
    return widest - narrowest;
  }

  bool has_gap(const std::vector<double>& heights) const {
    constexpr double wide = 1.5;
    const double middle = middle_gap(heights);
    for (std::size_t k = 1; k < heights.size(); ++k)
      if (heights[k] - heights[k - 1] > wide * middle) return true;
    return false;
  }

  [[noreturn]] void refuse_uneven(const std::vector<double>& heights, const Line& fit) const {
    const double middle = middle_gap(heights);
    std::size_t widest = 1, wide = 0;
    for (std::size_t k = 1; k < heights.size(); ++k) {
      if (heights[k] - heights[k - 1] > heights[widest] - heights[widest - 1]) widest = k;
      if (std::round((heights[k] - heights[k - 1]) / middle) > 1) ++wide;
    }
    const double gap = heights[widest] - heights[widest - 1];
    const DicomPlane &below = result_.planes[widest - 1], &above = result_.planes[widest];
    if (wide == 0) {
      refuse("uneven-slices",
             fmt::format("its slices are not evenly spaced: between {} and {} there are {:.4g} mm, in the middle "
                         "{:.4g} mm; even places are missed by {:.2g} mm",
                         name_of(below), name_of(above), gap, middle, fit.worst),
             "resample it evenly");
    }
    const double missing = std::round(gap / middle) - 1;
    refuse("uneven-slices",
           fmt::format(
               "{:.0f} {} missing between {} and {}: there are {:.4g} mm between them, and {:.4g} mm between others{}",
               missing, missing == 1 ? "slice is" : "slices are", name_of(below), name_of(above), gap, middle,
               wide == 1 ? "" : fmt::format("; there are {} such gaps", wide)),
           "complete the series, or resample it evenly");
  }

  /// Each slice straight above the last. A gantry that was tilted pushes them sideways.
  void check_straight(const std::vector<double>& heights) const {
    const Vector3 normal = result_.image.direction[2];
    const double step = result_.image.spacing[2];
    const double allowed =
        std::max(limits::slice_unevenness * step, std::min(4 * rounding(), limits::slice_rounding * step));
    for (std::size_t k = 1; k < heights.size(); ++k) {
      Vector3 off = minus(*frame_of(result_.planes[k]).position, *frame_of(result_.planes.front()).position);
      for (std::size_t x = 0; x < 3; ++x) off[x] -= heights[k] * normal[x];
      const double sideways = std::sqrt(dot(off, off));
      if (sideways <= allowed) continue;
      refuse("sheared-volume",
             fmt::format("{} lies {:.4g} mm beside the first slice, {:.4g} mm above it: slices are pushed by {:.3g} "
                         "degrees, as a tilted gantry does",
                         name_of(result_.planes[k]), sideways, heights[k],
                         portable::atan2(sideways, heights[k]) * 180 / std::numbers::pi),
             "resample the series onto a rectangular grid");
    }
  }

  /// Nothing says where they lie, but their numbers tell an order.
  void place_by_numbers() {
    if (!options_.spacing) {
      refuse("no-positions", "it does not say where its images lie, nor how far apart",
             "give the size of a voxel in mm (--spacing X,Y,Z); images are then taken in the order of their numbers, "
             "upwards");
    }
    std::stable_sort(planes().begin(), planes().end(), [](const DicomPlane& a, const DicomPlane& b) {
      return std::pair(a.image->instance_number, a.frame) < std::pair(b.image->instance_number, b.frame);
    });
    const DicomImage& first = *planes().front().image;
    if (first.first_place && first.frames.size() == planes().size()) {
      result_.image.origin = *first.first_place;
      result_.remarks.push_back(
          "its frames have no places of their own: they are put one after the other along the first one's normal");
      return;
    }
    result_.remarks.push_back(
        "it does not say where its images lie: they are taken in the order of their numbers, upwards; if that is "
        "wrong, the tooth is mirrored");
  }

  void collect_remarks() {
    std::set<std::string> told;
    for (const DicomPlane& plane : planes())
      for (const std::string& remark : plane.image->remarks)
        if (told.insert(remark).second) result_.remarks.push_back(remark);
  }

  const ReadVolumeOptions& options_;
  DicomStack result_;
};

}  // namespace

DicomStack stack_planes(const std::vector<const DicomImage*>& images, const std::string& source,
                        const ReadVolumeOptions& options) {
  return Stacking(images, source, options).run();
}

std::optional<double> slice_spacing_of(const std::vector<const DicomImage*>& images) {
  try {
    const ReadVolumeOptions as_it_says;
    return stack_planes(images, {}, as_it_says).image.spacing[2];
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace odontoscope
