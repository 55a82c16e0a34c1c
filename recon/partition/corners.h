#pragma once
// Points where four faces or more meet, parted. Inner part of planar_partition.h.

#include "recon/partition/overlay.h"

namespace odontoscope::partition {

/// Cuts corners off faces until no more than three meet in any point: a tiny triangle of one face goes to its neighbour. First where one material
/// meets itself across the point (it is parted), then where void does (it is closed), then the faces of least priority. Whether two corners of
/// one material that touch are joined cannot be told from a slice; a cut decides it, and is counted. Returns how many corners were cut.
std::size_t part_corners(Borders& borders, const Materials& materials);

}  // namespace odontoscope::partition
