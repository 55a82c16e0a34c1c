#pragma once
// The collapsing itself: surfaces in one queue, rounds that dare more and more. Inner part of simplify_surface.h.

#include <cstddef>
#include <vector>

#include "recon/core/progress.h"
#include "recon/mesh/meshes.h"

namespace odontoscope {

struct SurfaceToCollapse {
  const SurfaceMesh* surface;
  /// One for each point: an edge between two that are marked stays. What is marked keeps its place.
  const std::vector<char>* keep;
};

/// What became of one, and for each of its points the number that it had (or one of those that it stands for).
struct CollapsedSurface {
  SurfaceMesh surface;
  std::vector<PointIndex> original;
};

struct Collapse {
  std::vector<CollapsedSurface> surfaces;
  /// Edges that the last round could not collapse, by the first reason against it.
  std::size_t against_topology = 0, cutting = 0, misshapen = 0;
};

/// Until at most `triangles` are left in all, or no edge can be collapsed any more. Precondition: closed, oriented
/// manifolds. Stage "simplify".
Collapse collapse_edges(const std::vector<SurfaceToCollapse>& surfaces, std::size_t triangles,
                        const Progress& progress);

}  // namespace odontoscope
