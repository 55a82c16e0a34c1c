#pragma once
// A surface and what it is called.

#include <string>

#include "recon/mesh/meshes.h"

namespace odontoscope {

struct NamedMesh {
  std::string name;  // of a structure; of a node or solid of a file, where it may be empty
  SurfaceMesh surface;
};

}  // namespace odontoscope
