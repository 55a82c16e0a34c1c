#include "recon/volume/dicom_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "recon/core/limits.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/limits.h"
#include "recon/volume/text_header.h"

namespace odontoscope {
namespace {

/// Classes of objects that are slices or volumes, whole families of them (CT, MR, secondary capture, 3D X-ray, PET):
/// one without pixels has lost them.
constexpr std::array<std::string_view, 5> image_classes{"1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.4",
                                                        "1.2.840.10008.5.1.4.1.1.7", "1.2.840.10008.5.1.4.1.1.13.1",
                                                        "1.2.840.10008.5.1.4.1.1.128"};
constexpr std::string_view segmentation_class = "1.2.840.10008.5.1.4.1.1.66.4",
                           label_map_class = "1.2.840.10008.5.1.4.1.1.66.7";
constexpr std::string_view nuclear_class = "1.2.840.10008.5.1.4.1.1.20", dose_class = "1.2.840.10008.5.1.4.1.1.481.2";

bool is_image_class(std::string_view name) {
  return std::any_of(image_classes.begin(), image_classes.end(), [name](std::string_view family) {
    return name.starts_with(family) && (name.size() == family.size() || name[family.size()] == '.');
  });
}

[[noreturn]] void refuse(std::string_view cause, const DicomFile& file, const std::string& wrong,
                         std::string_view remedy) {
  throw InputError(cause, in_file(file.path), wrong, remedy);
}

constexpr std::string_view convert_it = "convert the series with the program that wrote it";

std::size_t whole(const DicomFile& file, std::uint32_t tag, const char* name, double least, double most,
                  double otherwise) {
  const double number = file.data.number(tag).value_or(otherwise);
  if (number >= least && number <= most && number == std::floor(number)) return static_cast<std::size_t>(number);
  refuse("unreadable-volume", file,
         fmt::format("its {} {}", name, file.data.find(tag) == nullptr ? "is missing" : fmt::format("is {}", number)),
         convert_it);
}

/// Unit vectors at right angles, within what headers round to.
std::optional<std::array<Vector3, 2>> orientation_of(const DicomFile& file, const DicomDataSet& data) {
  if (data.find(dicom::orientation) == nullptr) return std::nullopt;
  const std::vector<double> six = data.numbers(dicom::orientation);
  if (six.size() != 6)
    refuse("unreadable-volume", file, "its image orientation is not made of six finite numbers", convert_it);
  std::array<Vector3, 2> axes{{{six[0], six[1], six[2]}, {six[3], six[4], six[5]}}};
  for (Vector3& axis : axes) {
    const double length = std::sqrt(dot(axis, axis));
    if (!(std::abs(length - 1) <= 1e-2))
      refuse("unreadable-volume", file, "its image orientation is not made of unit vectors", convert_it);
    for (double& x : axis) x /= length;
  }
  if (std::abs(dot(axes[0], axes[1])) > limits::axes_out_of_square) {
    refuse("sheared-volume", file, "its rows and columns are not at right angles",
           "resample it onto a rectangular grid");
  }
  return axes;
}

std::optional<Vector3> position_of(const DicomFile& file, const DicomDataSet& data) {
  if (data.find(dicom::position) == nullptr || data.find(dicom::position)->value.empty()) return std::nullopt;
  const std::vector<double> three = data.numbers(dicom::position);
  if (three.size() != 3)
    refuse("unreadable-volume", file, "its image position is not made of three finite numbers", convert_it);
  return Vector3{three[0], three[1], three[2]};
}

std::optional<std::array<double, 2>> spacing_of(const DicomFile& file, const DicomDataSet& data, std::uint32_t tag) {
  if (data.find(tag) == nullptr || data.find(tag)->value.empty()) return std::nullopt;
  const std::vector<double> two = data.numbers(tag);  // between rows first
  if (two.size() != 2 || !(two[0] > 0) || !(two[1] > 0)) {
    refuse("bad-spacing", file, "its pixel spacing is not made of two positive numbers",
           "give the size of a voxel in mm (--spacing X,Y,Z)");
  }
  return std::array<double, 2>{two[1], two[0]};
}

/// A last digit of 0.1, 0.01, ... for the numbers of a decimal string with the most digits.
double grain_of(const std::string& text) {
  double grain = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\\'), rest.size());
    const std::string_view word = trimmed(rest.substr(0, end));
    const std::size_t point = word.find('.'), exponent = word.find_first_of("eE");
    double power = 0;
    if (exponent != word.npos) number_of(word.substr(exponent + 1), power);
    const std::size_t digits_end = std::min(exponent, word.size());
    const double digits = point == word.npos || point > digits_end ? 0 : static_cast<double>(digits_end - point - 1);
    const double own = std::pow(10, power - digits);
    grain = grain == 0 ? own : std::min(grain, own);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return grain;
}

/// Takes from `data` what it says of a frame; what it does not say stays.
void read_groups(const DicomImage& image, const DicomDataSet& data, DicomFrame& frame) {
  const DicomFile& file = image.file;
  if (const DicomDataSet* item = data.item(dicom::plane_position)) {
    if (const auto position = position_of(file, *item)) frame.position = position;
  }
  if (const DicomDataSet* item = data.item(dicom::plane_orientation)) {
    if (const auto orientation = orientation_of(file, *item)) frame.orientation = orientation;
  }
  if (const DicomDataSet* item = data.item(dicom::pixel_measures)) {
    if (const auto spacing = spacing_of(file, *item, dicom::pixel_spacing)) frame.spacing = spacing;
    if (const auto between = item->number(dicom::spacing_between_slices)) frame.slice_spacing = between;
    if (const auto thickness = item->number(dicom::slice_thickness)) frame.thickness = thickness;
  }
  if (const DicomDataSet* item = data.item(dicom::segment_identification)) {
    frame.segment =
        static_cast<std::uint32_t>(std::clamp(item->number(dicom::referenced_segment).value_or(0), 0.0, 65535.0));
  }
  if (const DicomDataSet* item = data.item(dicom::value_transformation)) {
    frame.slope = item->number(dicom::slope).value_or(frame.slope);
    frame.intercept = item->number(dicom::intercept).value_or(frame.intercept);
  }
}

/// The pixel spacing by the best of what is given, and says so where that is not the true one.
void read_top_spacing(DicomImage& image, DicomFrame& frame) {
  const DicomDataSet& data = image.file.data;
  frame.spacing = spacing_of(image.file, data, dicom::pixel_spacing);
  if (frame.spacing) return;
  frame.spacing = spacing_of(image.file, data, dicom::imager_spacing);
  if (frame.spacing) {
    const double magnification = data.number(dicom::magnification).value_or(1);
    for (double& x : *frame.spacing) x /= magnification > 0 ? magnification : 1;
    image.remarks.push_back(
        magnification != 1 && magnification > 0
            ? fmt::format(
                  "it gives the pixel spacing at the detector only, and a magnification of {}: their quotient is taken",
                  magnification)
            : "it gives the pixel spacing at the detector only (imager pixel spacing), which is taken; the true one "
              "may be smaller");
    return;
  }
  frame.spacing = spacing_of(image.file, data, dicom::nominal_spacing);
  if (frame.spacing) image.remarks.push_back("it gives the pixel spacing of a scanned picture only, which is taken");
}

DicomFrame top_frame(DicomImage& image) {
  const DicomDataSet& data = image.file.data;
  DicomFrame frame;
  frame.position = position_of(image.file, data);
  frame.orientation = orientation_of(image.file, data);
  read_top_spacing(image, frame);
  frame.slice_spacing = data.number(dicom::spacing_between_slices);
  frame.thickness = data.number(dicom::slice_thickness);
  frame.slope = data.number(dicom::slope).value_or(1);
  frame.intercept = data.number(dicom::intercept).value_or(0);
  if (data.text(dicom::class_uid) == dose_class) frame.slope = data.number(dicom::dose_scaling).value_or(1);
  return frame;
}

Vector3 normal_of(const std::array<Vector3, 2>& axes) {
  const Vector3 &a = axes[0], &b = axes[1];
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool any_text(const DicomDataSet& data, std::uint32_t tag) {
  return data.find(tag) != nullptr && !data.find(tag)->value.empty();
}

/// Do frames without places of their own follow each other in time?
bool is_film(const DicomImage& image) {
  constexpr double of_time = 0x0018;
  const DicomDataSet& data = image.file.data;
  const std::vector<double> pointers = data.numbers(dicom::frame_increment);
  for (std::size_t n = 0; n + 1 < pointers.size(); n += 2) {
    if (pointers[n] == of_time &&
        (pointers[n + 1] == (dicom::frame_time & 0xffff) || pointers[n + 1] == (dicom::frame_time_vector & 0xffff)))
      return true;
  }
  if (!pointers.empty()) return false;
  return any_text(data, dicom::frame_time) || any_text(data, dicom::frame_time_vector);
}

/// Frames without a place of their own: along the normal, as far apart as the file says.
void place_along_normal(DicomImage& image) {
  DicomFrame& first = image.frames.front();
  if (is_film(image)) {
    refuse("time-series", image.file,
           fmt::format("its {} frames follow each other in time: it is a film and no volume", image.frames.size()),
           "give a volume; of a film in space and time export one moment");
  }
  if (!first.orientation || !first.position) return;
  const Vector3 normal = normal_of(*first.orientation), from = *first.position;
  const DicomDataSet& data = image.file.data;
  const std::uint32_t vector = any_text(data, dicom::grid_offsets) ? dicom::grid_offsets : dicom::slice_location_vector;
  const std::vector<double> offsets = data.numbers(vector);
  if (any_text(data, vector)) {
    if (offsets.size() != image.frames.size()) {
      refuse("unreadable-volume", image.file,
             fmt::format("it gives the places of {} frames and has {}", offsets.size(), image.frames.size()),
             convert_it);
    }
    for (std::size_t n = 0; n < offsets.size(); ++n)
      for (std::size_t x = 0; x < 3; ++x)
        image.frames[n].position->at(x) = from[x] + (offsets[n] - offsets[0]) * normal[x];
    return;
  }
  double step = first.slice_spacing.value_or(0);
  // Only nuclear medicine says by a sign that slices run the other way.
  if (data.text(dicom::class_uid) != nuclear_class) step = std::abs(step);
  if (step == 0 && first.thickness.value_or(0) > 0) {
    step = *first.thickness;
    image.remarks.push_back(
        fmt::format("it gives no distance of its frames: their thickness of {} mm is taken for it", step));
  } else if (step != 0) {
    image.remarks.push_back(fmt::format(
        "its frames have no places of their own: they are put one after the other, {} mm apart", std::abs(step)));
  }
  if (step == 0) image.first_place = from;
  for (std::size_t n = 0; n < image.frames.size(); ++n) {
    if (step == 0)
      image.frames[n].position.reset();  // to be asked for
    else
      for (std::size_t x = 0; x < 3; ++x)
        image.frames[n].position->at(x) = from[x] + static_cast<double>(n) * step * normal[x];
  }
}

void read_frames(DicomImage& image, std::size_t count) {
  const DicomDataSet& data = image.file.data;
  DicomFrame common = top_frame(image);
  const bool top_position = common.position.has_value();
  if (const DicomDataSet* shared = data.item(dicom::shared_groups)) read_groups(image, *shared, common);
  image.frames.assign(count, common);
  const DicomElement* groups = data.find(dicom::frame_groups);
  std::size_t placed = 0;
  image.position_grain = top_position ? grain_of(data.text(dicom::position)) : 0;
  if (groups != nullptr && !groups->items.empty()) {
    if (groups->items.size() != count) {
      refuse("unreadable-volume", image.file,
             fmt::format("it tells of {} frames and has {}", groups->items.size(), count), convert_it);
    }
    for (std::size_t n = 0; n < count; ++n) {
      read_groups(image, groups->items[n], image.frames[n]);
      const DicomDataSet* plane = groups->items[n].item(dicom::plane_position);
      if (plane == nullptr || !position_of(image.file, *plane)) continue;
      ++placed;
      const double grain = grain_of(plane->text(dicom::position));
      image.position_grain = image.position_grain == 0 ? grain : std::min(image.position_grain, grain);
    }
  }
  if (placed == 0 && is_dicom_segmentation(image.file)) {
    refuse("no-positions", image.file, "it does not say where its frames lie",
           "export it as a label map (NRRD or NIfTI)");
  }
  if (placed != 0 && placed != count)
    refuse("unreadable-volume", image.file, fmt::format("only {} of its {} frames have a place", placed, count),
           convert_it);
  if (placed == 0 && count > 1) place_along_normal(image);
  if (count > 1 && placed == 0 && !image.frames.front().position) image.position_grain = 0;
  for (const DicomFrame& frame : image.frames) {
    if (frame.slope == 0)
      refuse("unreadable-volume", image.file, "its rescale slope is 0, which makes all its values one", convert_it);
  }
}

void check_length(const DicomImage& image) {
  const DicomPixels& pixels = image.file.pixels;
  if (pixels.encapsulated) {
    if (pixels.fragments.size() >= image.frames.size()) return;
    refuse("truncated-volume", image.file,
           fmt::format("it has {} frames and {} pieces of compressed pixels", image.frames.size(),
                       pixels.fragments.size()),
           "get a whole copy of the file");
  }
  // At most 2^16 * 2^16 * 2^32 * 2^6: in floating point, since it overflows 64 bits.
  const double needed = std::ceil(static_cast<double>(image.pixels()) * static_cast<double>(image.frames.size()) *
                                  image.bits_allocated / 8);
  if (static_cast<double>(pixels.length) >= needed) return;
  refuse("truncated-volume", image.file,
         fmt::format("{} frames of {} rows of {} pixels need {:.0f} bytes, it has {}", image.frames.size(), image.rows,
                     image.columns, needed, pixels.length),
         "get a whole copy of the file");
}

void read_pixel_format(DicomImage& image) {
  const DicomFile& file = image.file;
  image.photometric = file.data.text(dicom::photometric);
  if (const std::size_t samples = whole(file, dicom::samples, "number of samples a pixel", 1, 65535, 1); samples != 1) {
    refuse("not-scalar", file, fmt::format("each pixel has {} numbers (a colour)", samples),
           "give a grey-scale series");
  }
  if (image.photometric == "PALETTE COLOR" && !is_dicom_segmentation(file))
    refuse("not-scalar", file, "its pixels are colours of a palette", "give a grey-scale series");
  image.rows = whole(file, dicom::rows, "number of rows", 1, 65535, 0);
  image.columns = whole(file, dicom::columns, "number of columns", 1, 65535, 0);
  image.bits_allocated = static_cast<unsigned>(whole(file, dicom::bits_allocated, "number of bits a pixel", 1, 64, 0));
  const double all = image.bits_allocated;
  image.bits_stored = static_cast<unsigned>(whole(file, dicom::bits_stored, "number of bits stored", 1, all, all));
  image.high_bit = static_cast<unsigned>(
      whole(file, dicom::high_bit, "high bit", image.bits_stored - 1, all - 1, image.bits_stored - 1));
  image.is_signed = whole(file, dicom::is_signed, "pixel representation", 0, 1, 0) == 1;
  const bool floating = file.pixels.tag != dicom::pixel_data;
  const unsigned float_bits = file.pixels.tag == dicom::float_pixels ? 32 : 64;
  const bool known = floating ? image.bits_allocated == float_bits && !file.pixels.encapsulated
                              : image.bits_allocated == 8 || image.bits_allocated == 16 || image.bits_allocated == 32;
  const bool of_bits = image.bits_allocated == 1 && is_dicom_segmentation(file) && !file.pixels.encapsulated;
  if (!known && !of_bits) {
    refuse("pixel-type", file,
           fmt::format("its pixels have {}", image.bits_allocated == 1 ? "one bit, in an unusual coding"
                                                                       : fmt::format("{} bits", image.bits_allocated)),
           image.bits_allocated == 1 ? "export the segmentation as a label map (NRRD or NIfTI)" : convert_it);
  }
  if (file.data.item(dicom::modality_table) != nullptr) {
    image.remarks.push_back("its values are to be looked up in a table, which is not done: they are taken as stored");
  }
}

}  // namespace

bool is_dicom_segmentation(const DicomFile& file) {
  const std::string name =
      file.data.find(dicom::class_uid) == nullptr ? file.storage_class : file.data.text(dicom::class_uid);
  return name == segmentation_class || name == label_map_class;
}

bool is_dicom_image(const DicomFile& file) {
  return file.pixels.tag != 0 || file.data.find(dicom::rows) != nullptr ||
         is_image_class(file.data.find(dicom::class_uid) == nullptr ? file.storage_class
                                                                    : file.data.text(dicom::class_uid));
}

std::optional<DicomImage> dicom_image(DicomFile file) {
  if (file.trouble) throw *file.trouble;
  if (!is_dicom_image(file)) return std::nullopt;
  DicomImage image;
  image.file = std::move(file);
  const DicomDataSet& data = image.file.data;
  if (image.file.pixels.tag == 0)
    refuse("truncated-volume", image.file, "the image's pixels are missing", "get a whole copy of the file");
  image.series = data.text(dicom::series_uid);
  image.instance = data.text(dicom::instance_uid);
  image.concatenation = data.text(dicom::concatenation_uid);
  image.description = data.text(dicom::series_description);
  image.modality = data.text(dicom::modality);
  image.instance_number = data.number(dicom::instance_number).value_or(0);
  image.is_localizer = data.text(dicom::image_type).find("LOCALIZER") != std::string::npos;
  read_pixel_format(image);
  if (image.file.odd_lengths)
    image.remarks.push_back(
        "it has values with an odd number of bytes, which DICOM does not allow; it was read all the same");
  // Before frames are made for it, what it promises is held against what it has.
  const std::size_t count = whole(image.file, dicom::frames, "number of frames", 1, 4294967295.0, 1);
  const std::size_t most = image.file.pixels.encapsulated ? image.file.pixels.fragments.size()
                                                          : static_cast<std::size_t>(image.file.pixels.length * 8);
  const std::size_t limit = is_dicom_segmentation(image.file) ? limits::segment_frames : limits::slices;
  if (count > most)
    refuse("truncated-volume", image.file,
           fmt::format("it promises {} frames, which its pixels are too few for", count),
           "get a whole copy of the file");
  if (count > limit)
    refuse("too-many-voxels", image.file, fmt::format("it has {} frames; the limit is {}", count, limit),
           "crop it to the tooth");
  read_frames(image, count);
  check_length(image);
  return image;
}

}  // namespace odontoscope
