#pragma once
// The data set of a DICOM file, walked through from end to end by code of our own: the libraries that know DICOM end
// the program on some broken files, and make up what others lack. Inner part of read_volume.h.
//
// DICOM PS3.5, sections 7 (the data set) and A (transfer syntaxes); PS3.10, 7.1 (preamble and meta information).
//
// Little-endian, explicit or implicit; big-endian; deflated. With preamble, or without one (as older programs store,
// then implicit or explicit as its first element shows). Values are kept of those elements alone that say where an
// image lies and what its numbers mean (dicom_wanted.h).

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recon/core/error.h"

namespace odontoscope {

struct DicomElement;
class DicomSource;

/// Elements in the order of the file, wanted ones only.
struct DicomDataSet {
  std::vector<DicomElement> elements;
  /// Of an item: where it begins, as the records of a DICOMDIR name each other.
  std::uint64_t at = 0;

  /// Null if it is not there.
  const DicomElement* find(std::uint32_t tag) const;
  /// The first item of a sequence; null if there is none.
  const DicomDataSet* item(std::uint32_t sequence) const;
  /// Text without its padding; empty if it is not there.
  std::string text(std::uint32_t tag) const;
  /// Decimal strings or binary numbers, whichever it holds; empty if it is not there or none can be read. None of them
  /// is NaN or infinite.
  std::vector<double> numbers(std::uint32_t tag) const;
  /// Of one number.
  std::optional<double> number(std::uint32_t tag) const;
};

struct DicomElement {
  std::uint32_t tag = 0;
  std::array<char, 2> vr{};  // zeros where it is implied
  bool big_endian = false;
  std::string value;
  std::vector<DicomDataSet> items;  // of a sequence
};

/// Where pixels lie; offsets in the file, or in what it unpacks to.
struct DicomPixels {
  struct Fragment {
    std::uint64_t at = 0;
    std::uint32_t length = 0;
  };
  std::uint32_t tag = 0;  // 0: there are none
  std::uint64_t at = 0, length = 0;
  /// Of encapsulated pixels, without the table of offsets, which comes first.
  std::vector<Fragment> fragments;
  std::vector<std::uint32_t> offset_table;
  bool encapsulated = false;
  bool words = false;  // of 16 bits (VR OW)
};

struct DicomFile {
  std::string path;
  /// Transfer syntax and class of the object, by the meta information; empty without.
  std::string syntax, storage_class;
  bool implicit_vr = false, big_endian = false, deflated = false;
  bool has_preamble = true;
  DicomDataSet data;
  DicomPixels pixels;
  /// A value has an odd number of bytes, which DICOM does not allow, but which harms nothing.
  bool odd_lengths = false;
  /// What is wrong with it; what was read before that place is there. InputError truncated-volume, unreadable-volume or
  /// damaged-volume.
  std::optional<InputError> trouble;
};

/// Never throws for what is in the file: see `trouble`. Throws FileError if it cannot be opened. Sequences may lie
/// limits::dicom_nesting deep, and limits::dicom_elements wanted elements are kept at most.
DicomFile read_dicom_file(const std::string& path);

/// `count` bytes from `at` on, of the file as it lies or of what it unpacks to. Opened once for all pixels of a file.
class DicomBytes {
 public:
  explicit DicomBytes(const DicomFile& file);
  ~DicomBytes();
  DicomBytes(const DicomBytes&) = delete;
  DicomBytes& operator=(const DicomBytes&) = delete;
  /// Throws InputError truncated-volume if there are fewer.
  void read(std::uint64_t at, char* to, std::size_t count);

 private:
  std::unique_ptr<DicomSource> source_;
  std::string path_;
};

/// Is there the mark of a DICOM file ("DICM" after 128 bytes), or, without one, a first element as objects without
/// preamble have?
bool looks_like_dicom(const std::string& path);

namespace dicom {
constexpr std::uint32_t tag(std::uint32_t group, std::uint32_t element) { return group << 16 | element; }
inline constexpr std::uint32_t first_record = tag(0x0004, 0x1200), records = tag(0x0004, 0x1220),
                               next_record = tag(0x0004, 0x1400), record_in_use = tag(0x0004, 0x1410),
                               lower_record = tag(0x0004, 0x1420), record_type = tag(0x0004, 0x1430),
                               file_id = tag(0x0004, 0x1500), image_type = tag(0x0008, 0x0008),
                               class_uid = tag(0x0008, 0x0016), instance_uid = tag(0x0008, 0x0018),
                               modality = tag(0x0008, 0x0060), series_description = tag(0x0008, 0x103e),
                               slice_thickness = tag(0x0018, 0x0050), spacing_between_slices = tag(0x0018, 0x0088),
                               frame_time = tag(0x0018, 0x1063), frame_time_vector = tag(0x0018, 0x1065),
                               magnification = tag(0x0018, 0x1114), imager_spacing = tag(0x0018, 0x1164),
                               slice_location_vector = tag(0x0018, 0x2005), nominal_spacing = tag(0x0018, 0x2010),
                               series_uid = tag(0x0020, 0x000e), instance_number = tag(0x0020, 0x0013),
                               position = tag(0x0020, 0x0032), orientation = tag(0x0020, 0x0037),
                               frame_content = tag(0x0020, 0x9111), plane_position = tag(0x0020, 0x9113),
                               plane_orientation = tag(0x0020, 0x9116), temporal_index = tag(0x0020, 0x9128),
                               concatenation_uid = tag(0x0020, 0x9161), samples = tag(0x0028, 0x0002),
                               photometric = tag(0x0028, 0x0004), frames = tag(0x0028, 0x0008),
                               frame_increment = tag(0x0028, 0x0009), rows = tag(0x0028, 0x0010),
                               columns = tag(0x0028, 0x0011), pixel_spacing = tag(0x0028, 0x0030),
                               bits_allocated = tag(0x0028, 0x0100), bits_stored = tag(0x0028, 0x0101),
                               high_bit = tag(0x0028, 0x0102), is_signed = tag(0x0028, 0x0103),
                               intercept = tag(0x0028, 0x1052), slope = tag(0x0028, 0x1053),
                               modality_table = tag(0x0028, 0x3000), pixel_measures = tag(0x0028, 0x9110),
                               value_transformation = tag(0x0028, 0x9145), grid_offsets = tag(0x3004, 0x000c),
                               dose_scaling = tag(0x3004, 0x000e), character_set = tag(0x0008, 0x0005),
                               study_date = tag(0x0008, 0x0020), study_time = tag(0x0008, 0x0030),
                               accession = tag(0x0008, 0x0050), referring = tag(0x0008, 0x0090),
                               study_description = tag(0x0008, 0x1030), patient_name = tag(0x0010, 0x0010),
                               patient_id = tag(0x0010, 0x0020), patient_birth = tag(0x0010, 0x0030),
                               patient_sex = tag(0x0010, 0x0040), study_uid = tag(0x0020, 0x000d),
                               study_id = tag(0x0020, 0x0010), segmentation_type = tag(0x0062, 0x0001),
                               segments = tag(0x0062, 0x0002), segment_number = tag(0x0062, 0x0004),
                               segment_label = tag(0x0062, 0x0005), segment_identification = tag(0x0062, 0x000a),
                               referenced_segment = tag(0x0062, 0x000b), fraction_of = tag(0x0062, 0x000e),
                               referenced_series = tag(0x0008, 0x1115), referenced_instances = tag(0x0008, 0x114a),
                               referenced_class = tag(0x0008, 0x1150), referenced_instance = tag(0x0008, 0x1155),
                               frame_of_reference = tag(0x0020, 0x0052), position_indicator = tag(0x0020, 0x1040),
                               shared_groups = tag(0x5200, 0x9229), frame_groups = tag(0x5200, 0x9230),
                               float_pixels = tag(0x7fe0, 0x0008), double_pixels = tag(0x7fe0, 0x0009),
                               pixel_data = tag(0x7fe0, 0x0010);

/// What tells whose image it is, and of which study: kept for files that are written back.
inline constexpr std::array<std::uint32_t, 10> identity{study_date,        study_time,   accession,  referring,
                                                        study_description, patient_name, patient_id, patient_birth,
                                                        patient_sex,       study_id};
}  // namespace dicom

}  // namespace odontoscope
