#pragma once
// A large file's voxels, no more of them than are wanted: those of a part, and blocks of them as one. Nothing else of
// the file is ever held. Inner part of read_volume.h.

#include "recon/volume/oriented_image.h"
#include "recon/volume/pixel_file.h"
#include "recon/volume/read_volume.h"

namespace odontoscope {

/// What is kept of `image`, whose values lie in `files`: voxels within the part's bounds, or all; blocks of them,
/// finest axis first, until no more than part.most_voxels are left. A block at the end of an axis may have fewer voxels
/// than others. The result's grid is that of the blocks: its origin is where the first block's middle lies, or, where
/// blocks are sampled, its first voxel. Throws as read_pixels does. Memory: what is kept, and one layer of blocks.
FileImage read_part(FileImage image, const PixelFiles& files, const VolumePart& part, const Progress& progress);

}  // namespace odontoscope
