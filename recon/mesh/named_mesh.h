#pragma once
// A surface and what it is called.

#include <string>
#include <vector>

#include "recon/mesh/meshes.h"

namespace odontoscope {

struct NamedMesh {
  std::string name;  // of a structure; of a node or solid of a file, where it may be empty
  SurfaceMesh surface;
  /// By readers only: what was not as it should be and was made good, or left aside, a line each. Of the whole file
  /// with its first mesh.
  std::vector<std::string> remarks = {};
};

}  // namespace odontoscope
