// Any bytes to each reader of meshes (the first byte says which), and a plane through whatever comes out.
#include "recon/exchange/cut_surfaces.h"
#include "recon/mesh/read_mesh.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  using Parser = std::vector<NamedMesh> (*)(std::string_view, const std::string&);
  constexpr Parser parsers[] = {parse_glb, parse_stl, parse_ply, parse_obj};
  return fuzz::refused_or_read([&] {
    std::vector<NamedMesh> surfaces;
    for (NamedMesh& mesh : parsers[data[0] % 4](fuzz::text(data + 1, size - 1), "fuzz")) surfaces.push_back({"tooth", std::move(mesh.surface)});
    const double middle = surfaces.front().surface.points.front().z;
    for (const bool repair : {false, true}) {
      fuzz::refused_or_read([&] { cut_surfaces(surfaces, {middle - 0.1, middle, middle + 0.1}, "fuzz", {.repair = repair, .widest_gap = 10}); });
    }
  });
}
