#include "engine/app/sniff.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace odontoscope::app {
namespace {

bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t header = 80, preamble = header + sizeof(std::uint32_t), triangle = 50;
  static_assert(std::endian::native == std::endian::little, "the count is read as it lies in the file");
  if (bytes.size() < preamble) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, bytes.data() + header, sizeof(triangles));
  return bytes.size() == preamble + std::size_t{triangle} * triangles;
}

bool has_dicom_mark(std::string_view bytes) {
  constexpr std::size_t preamble = 128;
  return bytes.size() > preamble && bytes.substr(preamble).starts_with("DICM");
}

bool has_nifti_mark(std::string_view bytes) {
  constexpr std::size_t mark_at = 344;
  return bytes.size() > mark_at && (bytes.substr(mark_at).starts_with("n+1") || bytes.substr(mark_at).starts_with("ni1"));
}

}  // namespace

FileKind kind_of(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return FileKind::glb;
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return FileKind::ply;
  if (is_binary_stl(bytes)) return FileKind::stl;   // before the text one: some binary files begin with "solid" as well
  if (bytes.starts_with("NRRD000") || has_dicom_mark(bytes) || has_nifti_mark(bytes)) return FileKind::volume;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return FileKind::unknown;
  bytes.remove_prefix(first);
  if (bytes.starts_with('{')) return FileKind::contour_stack;
  if (bytes.starts_with("solid")) return FileKind::stl;
  if (bytes.starts_with("ObjectType")) return FileKind::volume;
  return FileKind::unknown;
}

}  // namespace odontoscope::app
