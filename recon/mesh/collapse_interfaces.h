#pragma once
// The collapsing itself: interfaces in one queue, the cheapest edge first. Inner part of simplify_interfaces.h.

#include <cstddef>
#include <vector>

#include "recon/core/progress.h"
#include "recon/mesh/interface_web.h"
#include "recon/mesh/simplify_surface.h"

namespace odontoscope {

/// Triangles of all materials' surfaces: what two materials share is in both.
std::size_t triangles_of_surfaces(const std::vector<InterfaceTriangle>& faces);

/// Until at most `triangles` are left in the surfaces of all materials, or no edge can be collapsed any more: then
/// `obstacles`, by the first reason against each. `keep`, one for each point: an edge between two that are marked
/// stays; what is marked keeps its place. Stage "simplify".
SimplifiedSurfaces::Obstacles collapse_interfaces(InterfaceWeb& web, const std::vector<char>& keep,
                                                  std::size_t triangles, const Progress& progress);

}  // namespace odontoscope
