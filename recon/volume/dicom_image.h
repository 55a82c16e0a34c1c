#pragma once
// What a DICOM file says of the image or images in it: each frame's place in the patient, and what its numbers mean.
// Inner part of read_volume.h.
//
// DICOM PS3.3: C.7.6.2 (image plane), C.7.6.16 (functional groups of Enhanced CT, MR and their like: plane position,
// plane orientation, pixel measures and pixel value transformation, each shared by all frames or each frame's own),
// C.7.6.6 (frames without such groups), C.8.8.3 (dose grids), C.8.15.3 (frames of secondary captures along a normal).
// What a frame's own group says goes before the shared one, and that before the top level.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recon/volume/dicom_file.h"
#include "recon/volume/oriented_image.h"
#include "recon/volume/pixel_file.h"

namespace odontoscope {

struct DicomFrame {
  /// Centre of the first pixel, mm.
  std::optional<Vector3> position;
  /// Unit vectors along which columns and rows count up.
  std::optional<std::array<Vector3, 2>> orientation;
  /// Between columns and between rows, mm: x and y of the image.
  std::optional<std::array<double, 2>> spacing;
  std::optional<double> slice_spacing, thickness;
  double slope = 1, intercept = 0;
  /// Of a segmentation: the segment whose pixels it has; 0 if it does not say.
  std::uint32_t segment = 0;
};

struct DicomImage {
  DicomFile file;
  std::string series, instance, concatenation, description, modality;
  double instance_number = 0;
  std::size_t rows = 0, columns = 0;
  unsigned bits_allocated = 0, bits_stored = 0, high_bit = 0;
  bool is_signed = false;
  std::string photometric;
  std::vector<DicomFrame> frames;
  /// Of the first of several frames that do not say how far apart they are, and so have no places.
  std::optional<Vector3> first_place;
  /// A scout: an overview from the side that lies in the series of the slices it helped to plan.
  bool is_localizer = false;
  /// The last digit that its positions are written with, mm: they are rounded to it.
  double position_grain = 0;
  std::vector<std::string> remarks;

  std::size_t pixels() const { return rows * columns; }
};

/// Nothing for objects that are no images (structure sets, reports, DICOMDIR). Throws the file's trouble; InputError
/// truncated-volume (an image without pixels, or with fewer than its size makes), not-scalar (colours), pixel-type,
/// time-series (its frames follow each other in time), unreadable-volume.
std::optional<DicomImage> dicom_image(DicomFile file);

/// A segmentation: one frame for each segment and slice (PS3.3, A.51), or one for each slice, whose pixels are
/// segments' numbers. See dicom_segmentation.h.
bool is_dicom_segmentation(const DicomFile& file);

/// Is it an image, of whatever kind? What is found out without looking at its frames.
bool is_dicom_image(const DicomFile& file);

}  // namespace odontoscope
