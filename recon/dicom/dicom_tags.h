#pragma once
// Elements of DICOM by the names that they have here (PS3.6).

#include <array>
#include <cstdint>

namespace odontoscope {

namespace dicom {
constexpr std::uint32_t tag(std::uint32_t group, std::uint32_t element) { return group << 16 | element; }
inline constexpr std::uint32_t storage_class = tag(0x0002, 0x0002), transfer_syntax = tag(0x0002, 0x0010),
                               item = tag(0xfffe, 0xe000), item_end = tag(0xfffe, 0xe00d),
                               sequence_end = tag(0xfffe, 0xe0dd);
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
                               referenced_frame = tag(0x0008, 0x1160), referenced_frames = tag(0x3006, 0x0010),
                               referenced_studies = tag(0x3006, 0x0012), referenced_study_series = tag(0x3006, 0x0014),
                               contour_images = tag(0x3006, 0x0016), roi_sequence = tag(0x3006, 0x0020),
                               roi_number = tag(0x3006, 0x0022), roi_frame_of_reference = tag(0x3006, 0x0024),
                               roi_name = tag(0x3006, 0x0026), contours_by_roi = tag(0x3006, 0x0039),
                               contour_sequence = tag(0x3006, 0x0040), geometric_type = tag(0x3006, 0x0042),
                               point_count = tag(0x3006, 0x0046), contour_data = tag(0x3006, 0x0050),
                               referenced_roi = tag(0x3006, 0x0084), float_pixels = tag(0x7fe0, 0x0008),
                               double_pixels = tag(0x7fe0, 0x0009), pixel_data = tag(0x7fe0, 0x0010);

constexpr bool is_pixels(std::uint32_t tag) { return tag == pixel_data || tag == float_pixels || tag == double_pixels; }

/// What tells whose image it is, and of which study: kept for files that are written back.
inline constexpr std::array<std::uint32_t, 10> identity{study_date,        study_time,   accession,  referring,
                                                        study_description, patient_name, patient_id, patient_birth,
                                                        patient_sex,       study_id};
}  // namespace dicom

}  // namespace odontoscope
