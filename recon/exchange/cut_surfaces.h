#pragma once
// Surface meshes cut into contours, plane by plane: the way back from anybody's model.
//
// Which triangles a plane crosses, and how its points join up, is decided by signs alone: a plane is cut as if it lay
// lower, and as if it lay higher, by less than any number, so that no vertex lies in it (symbolic perturbation, after
// H. Edelsbrunner and E. P. Muecke, "Simulation of simplicity", ACM Transactions on Graphics 9(1), 1990). So a closed
// surface always gives closed contours. A section is what is material on either side: a flat piece in the plane gives
// its outline, a plane that only touches gives nothing, and a model that was made of slices gives them back at their
// heights. Points are rounded once; where a vertex lies in the plane they are that vertex. Where contours meet in such
// a vertex, corners are cut off there by a 64th of their edges, since contours keep apart.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/core/progress.h"
#include "recon/exchange/repair_contours.h"
#include "recon/input/validate.h"
#include "recon/mesh/named_mesh.h"

namespace odontoscope {

struct CutOptions {
  /// Close gaps, untangle contours; tell what was changed.
  bool repair = false;
  /// With `repair`: the widest gap in a plane that is closed by a straight line, mm.
  double widest_gap = 0.5;
};

struct CutContours {
  ValidStack stack;                    // a slice for each height, in their order
  std::vector<ContourChange> changes;  // none without `repair`
};

/// Heights at `spacing` from half of it above the lowest point on. UsageError for a spacing that is not positive or
/// gives more slices than limits::slices or fewer than two.
std::vector<double> heights_at(const std::vector<NamedMesh>& surfaces, double spacing);

/// Surfaces of one name are cut as one: a structure's outside and its cavities. `file` is for messages. The result has
/// passed `validate`, or InputError is thrown, with one of that function's causes or
///   open-surface, crowded-edge, misoriented-surface   without `repair`: the surface is no closed, oriented manifold
///   section-meets-itself   without `repair`: contours of one structure touch or cross, since the surface cuts through
///   itself gap-too-wide           with `repair`
/// Preconditions: indices in range, coordinates finite; heights ascending. Stage "cut".
CutContours cut_surfaces(const std::vector<NamedMesh>& surfaces, const std::vector<double>& heights,
                         const std::string& file, const CutOptions& options = {}, const Progress& progress = {});

}  // namespace odontoscope
