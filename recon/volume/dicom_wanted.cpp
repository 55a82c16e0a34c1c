#include "recon/volume/dicom_wanted.h"

#include <algorithm>
#include <array>

#include "recon/dicom/dicom_tags.h"

namespace odontoscope::dicom {
namespace {

constexpr std::array<std::uint32_t, 69> wanted{first_record,
                                               records,
                                               image_type,
                                               class_uid,
                                               instance_uid,
                                               modality,
                                               series_description,
                                               slice_thickness,
                                               spacing_between_slices,
                                               frame_time,
                                               frame_time_vector,
                                               magnification,
                                               imager_spacing,
                                               slice_location_vector,
                                               nominal_spacing,
                                               series_uid,
                                               instance_number,
                                               position,
                                               orientation,
                                               frame_content,
                                               plane_position,
                                               plane_orientation,
                                               temporal_index,
                                               concatenation_uid,
                                               samples,
                                               photometric,
                                               frames,
                                               frame_increment,
                                               rows,
                                               columns,
                                               pixel_spacing,
                                               bits_allocated,
                                               bits_stored,
                                               high_bit,
                                               is_signed,
                                               intercept,
                                               slope,
                                               modality_table,
                                               pixel_measures,
                                               value_transformation,
                                               grid_offsets,
                                               dose_scaling,
                                               shared_groups,
                                               frame_groups,
                                               character_set,
                                               study_date,
                                               study_time,
                                               accession,
                                               referring,
                                               study_description,
                                               patient_name,
                                               patient_id,
                                               patient_birth,
                                               patient_sex,
                                               study_uid,
                                               study_id,
                                               frame_of_reference,
                                               position_indicator,
                                               segmentation_type,
                                               segments,
                                               segment_number,
                                               segment_label,
                                               segment_identification,
                                               referenced_segment,
                                               fraction_of,
                                               referenced_series,
                                               referenced_instances,
                                               referenced_class,
                                               referenced_instance};

constexpr std::array<std::uint32_t, 6> wanted_of_record{next_record, record_in_use, lower_record,
                                                        record_type, file_id,       series_uid};

template <class Tags>
bool has(const Tags& tags, std::uint32_t tag) {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

}  // namespace

bool is_wanted(std::uint32_t tag) { return has(wanted, tag); }
bool is_wanted_of_record(std::uint32_t tag) { return has(wanted_of_record, tag); }

}  // namespace odontoscope::dicom
