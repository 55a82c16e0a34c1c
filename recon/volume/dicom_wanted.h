#pragma once
// Which elements of a DICOM file are of use. Inner part of dicom_file.h.

#include <cstdint>

namespace odontoscope::dicom {

/// Elements whose values are kept. Of sequences also the items.
bool is_wanted(std::uint32_t tag);
/// And of the records of a DICOMDIR, each of which repeats much of what its file says.
bool is_wanted_of_record(std::uint32_t tag);

}  // namespace odontoscope::dicom
