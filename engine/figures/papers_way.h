#pragma once
// The DT method as the paper has it: each slab by itself. The figures keep to it, whatever the product's default is.

#include "recon/delaunay/reconstruct.h"

namespace odontoscope::figures {

inline ReconstructOptions papers_way() {
  ReconstructOptions options;
  options.correspondence = Correspondence::medial;
  options.between = Between::delaunay;
  return options;
}

}  // namespace odontoscope::figures
