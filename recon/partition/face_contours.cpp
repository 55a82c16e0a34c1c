#include "recon/partition/face_contours.h"

#include "recon/core/error.h"

namespace odontoscope::partition {

std::vector<Contour> face_contours(const Borders& borders, const std::string& name,
                                   const std::function<bool(Label)>& chosen) {
  constexpr std::uint32_t nowhere = 0xffffffffu;
  std::vector<std::uint32_t> next(borders.points.size(), nowhere);
  const auto lead = [&](std::uint32_t from, std::uint32_t to) {
    if (next[from] != nowhere) throw InternalError("faces of one material meet in a point");
    next[from] = to;
  };
  for (const Border& piece : borders.pieces) {
    const bool left = chosen(piece.left), right = chosen(piece.right);
    if (left && !right) lead(piece.a, piece.b);
    if (right && !left) lead(piece.b, piece.a);
  }
  std::vector<Contour> contours;
  for (std::uint32_t start = 0; start < next.size(); ++start) {
    if (next[start] == nowhere) continue;
    contours.push_back({name, {}});
    for (std::uint32_t p = start; next[p] != nowhere;) {
      contours.back().points.push_back(borders.points[p]);
      const std::uint32_t after = next[p];
      next[p] = nowhere;
      p = after;
    }
  }
  return contours;
}

}  // namespace odontoscope::partition
