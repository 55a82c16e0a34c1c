#include "engine/app/sniff.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"

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
  return bytes.size() > mark_at &&
         (bytes.substr(mark_at).starts_with("n+1") || bytes.substr(mark_at).starts_with("ni1"));
}

/// The first word of the first line that is neither empty nor a comment.
std::string_view first_word(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (!text.starts_with('#')) return text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
  }
}

bool is_obj(std::string_view bytes) {
  const std::string_view word = first_word(bytes);
  for (const std::string_view known :
       {"v", "vn", "vt", "vp", "f", "o", "g", "s", "mtllib", "usemtl", "maplib", "usemap", "cstype"}) {
    if (word == known) return true;
  }
  return false;
}

/// glTF must have this key, and a contour stack may not.
bool names_an_asset(std::string_view json) {
  constexpr std::size_t looked_at = 4096;
  const std::string_view head = json.substr(0, looked_at);
  return head.find("\"asset\"") != head.npos && head.find("\"odontoscope.") == head.npos;
}

FileKind kind_by_content(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return FileKind::glb;
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return FileKind::ply;
  if (is_binary_stl(bytes)) return FileKind::stl;  // before the text one: some binary files begin with "solid" as well
  if (bytes.starts_with("NRRD000") || has_dicom_mark(bytes) || has_nifti_mark(bytes)) return FileKind::volume;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return FileKind::unknown;
  bytes.remove_prefix(first);
  if (bytes.starts_with('{')) return FileKind::contour_stack;
  if (bytes.starts_with("solid")) return FileKind::stl;
  if (bytes.starts_with("ObjectType")) return FileKind::volume;
  return is_obj(bytes) ? FileKind::obj : FileKind::unknown;
}

}  // namespace

FileKind kind_of(std::string_view bytes, const std::string& file) {
  const FileKind kind = kind_by_content(bytes);
  const std::string name = lower_case(file);
  if (kind == FileKind::unknown && name.ends_with(".stl") && !bytes.empty()) return FileKind::stl;
  if (kind == FileKind::unknown && name.ends_with(".obj") && !bytes.empty()) return FileKind::obj;
  if (kind == FileKind::contour_stack && (name.ends_with(".gltf") || names_an_asset(bytes))) return FileKind::gltf;
  return kind;
}

std::optional<std::vector<NamedMesh>> meshes_in(FileKind kind, std::string_view bytes, const std::string& file) {
  switch (kind) {
    case FileKind::glb:
      return parse_glb(bytes, file);
    case FileKind::ply:
      return parse_ply(bytes, file);
    case FileKind::stl:
      return parse_stl(bytes, file);
    case FileKind::obj:
      return parse_obj(bytes, file);
    case FileKind::gltf:
      return parse_gltf(bytes, file);
    default:
      return std::nullopt;
  }
}

std::string structure_of_mesh(const std::string& mesh) {
  for (const std::string_view kind : {"external", "cavity", "open"})
    if (mesh.size() > kind.size() + 1 && mesh.ends_with(kind) &&
        (mesh[mesh.size() - kind.size() - 1] == ' ' || mesh[mesh.size() - kind.size() - 1] == '_'))
      return mesh.substr(0, mesh.size() - kind.size() - 1);
  return mesh;
}

}  // namespace odontoscope::app
