#pragma once
// A GLB of ours made smaller with meshoptimizer (extension EXT_meshopt_compression). For the .cpp files of this room
// only.
//
// Nothing is lost: every number keeps its bits, every triangle its corners, in their order up to a rotation. The order
// of triangles and of vertices changes, so that neighbours stand beside each other. The extension is required: there is
// no second, plain copy of the numbers in the file.

#include <string>

namespace odontoscope {

/// Precondition: what glb_bytes wrote: one buffer, a view of its own for each accessor, components of four bytes. The
/// same input gives the same bytes.
std::string compressed_glb(const std::string& glb);
/// The same as one text (.gltf), its buffer embedded.
std::string compressed_gltf(const std::string& glb);

}  // namespace odontoscope
