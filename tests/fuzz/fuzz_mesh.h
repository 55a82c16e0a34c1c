#pragma once
// Any bytes to one reader of meshes, and planes through whatever comes out.

#include <utility>

#include "recon/exchange/cut_surfaces.h"
#include "recon/formats/read_mesh.h"
#include "tests/fuzz/fuzz_bytes.h"

namespace odontoscope::fuzz {

template <class Parse>
int mesh(Parse parse, const std::uint8_t* data, std::size_t size) {
  return refused_or_read([&] {
    std::vector<NamedMesh> surfaces;
    for (NamedMesh& mesh : parse(text(data, size), "fuzz")) {
      for (const Triangle& triangle : mesh.surface.triangles) {
        for (const PointIndex corner : triangle) require(corner < mesh.surface.points.size());
      }
      surfaces.push_back({"tooth", std::move(mesh.surface)});
    }
    require(!surfaces.empty() && !surfaces.front().surface.points.empty());
    const double middle = surfaces.front().surface.points.front().z;
    for (const bool repair : {false, true}) {
      refused_or_read([&] {
        cut_surfaces(surfaces, {middle - 0.1, middle, middle + 0.1}, "fuzz", {.repair = repair, .widest_gap = 10});
      });
    }
  });
}

}  // namespace odontoscope::fuzz
