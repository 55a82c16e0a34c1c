#pragma once
// Contours of structures that overlap or share walls, parted: each place belongs to one structure, and neighbours share
// their border to the bit.

#include <string>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/partition/contour_overlay.h"

namespace odontoscope::partition {

/// Structure after structure the contours round its own faces, outer ones counter-clockwise, holes clockwise. `borders`
/// are those of the stack's slices.
ContourStack own_faces(const ContourStack& stack, const std::vector<Borders>& borders, const Materials& materials);

/// Of a stack that `validate` passes and whose slices ascend: the same slices. `priority` as for reconstruct_partition,
/// whose errors this throws.
ContourStack own_faces(const ContourStack& stack, const std::vector<std::string>& priority = {});

}  // namespace odontoscope::partition
