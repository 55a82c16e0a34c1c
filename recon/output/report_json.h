#pragma once
// What is known of a result, as JSON for people and scripts. docs/formats.md describes every key.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "recon/core/rigid_motion.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/mesh/simplify_surface.h"
#include "recon/output/element_model.h"

namespace odontoscope {

/// How a structure's surface was made coarser after the reconstruction.
struct StructureSimplification {
  std::string structure;
  std::size_t triangles_before = 0, triangles = 0;
  SurfaceDistance distance;  // `a_to_b`: from the simplified surface to the full one
  std::size_t self_intersections = 0, kept_vertices = 0;
  /// Of the full surface's bounding box, mm: what the distance is held against.
  double diagonal = 0;
};

/// What simplifying was to reach for all structures together, and what it reached.
struct SimplificationAim {
  std::size_t aim = 0, triangles = 0;
  SimplifiedSurfaces::Obstacles obstacles;  // if not reached
  std::size_t restarts = 0;
  bool reached() const { return triangles <= aim; }
};

/// The volume that the contours were taken from.
struct ReportVolume {
  /// Structures and the values at which their surfaces were taken.
  std::vector<std::pair<std::string, double>> isos;
  /// What was assumed and left out, see Volume::remarks.
  std::vector<std::string> remarks;
  /// From the file's coordinates to those of the contours, if it was stood upright.
  std::optional<RigidMotion> upright = {};
  /// The model was put back to where the file has it.
  bool as_given = false;
};

struct ReportOptions {
  /// If not empty, those surfaces of the reconstruction are the simplified ones.
  std::vector<StructureSimplification> simplifications;
  std::optional<ReportVolume> volume = {};
  std::optional<SimplificationAim> aim;
  std::optional<ModelElements> elements = {};
};

/// One JSON object, keys in a fixed order, two spaces a level: input, volume (only if there was one), tetrahedra,
/// surface, structures, resampling, links, void_links, topology, changes, attention, cut_links, simplification_aim and
/// simplification (only if there was one), elements (only if it was meshed anew), seconds, threads, certified, verdict
/// (see recon/delaunay/verdict.h). `certified` is true if the reconstruction is and every surface in it, as it now is,
/// is a closed oriented manifold. Lengths in mm, volumes in mm^3, angles in degrees. Measures the tetrahedra, which
/// takes a moment. Only `seconds` and `threads` differ between two runs on the same input.
std::string report_json(const Reconstruction& reconstruction, const ReportOptions& options = {});

/// The same of a DB model: method, input, db (grid, field, cases, decimation), surface, structures, resampling,
/// seconds, threads, certified. `options` are those that it was made with.
std::string report_json(const DbReconstruction& reconstruction, const DbOptions& options);

struct NamedSurfaceReport {
  std::string name;
  SurfaceReport report;
};

/// What `odontoscope check` says of a mesh file: {"file", "closed_oriented_manifold", "surface" (all meshes together),
/// "meshes":
/// [{"name", ...}]}.
std::string surface_report_json(const std::string& file, const std::vector<NamedSurfaceReport>& meshes);

}  // namespace odontoscope
