#include "recon/partition/own_faces.h"

#include <utility>

#include "recon/partition/face_contours.h"

namespace odontoscope::partition {

ContourStack own_faces(const ContourStack& stack, const std::vector<Borders>& borders, const Materials& materials) {
  ContourStack own;
  own.source = stack.source;
  const auto last = static_cast<Label>(materials.structures.size());
  for (std::size_t k = 0; k < borders.size(); ++k) {
    Slice slice{stack.slices[k].z, {}};
    for (Label l = 1; l <= last; ++l)
      for (Contour& face :
           face_contours(borders[k], materials.structures[l - 1], [l](Label label) { return label == l; }))
        slice.contours.push_back(std::move(face));
    own.slices.push_back(std::move(slice));
  }
  return own;
}

ContourStack own_faces(const ContourStack& stack, const std::vector<std::string>& priority) {
  const Materials materials = materials_of(stack, priority);
  std::vector<Borders> borders;
  for (const Slice& slice : stack.slices) borders.push_back(overlay(slice, materials));
  return own_faces(stack, borders, materials);
}

}  // namespace odontoscope::partition
