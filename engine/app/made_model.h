#pragma once
// What `reconstruct` made, on its way to files and words.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/console.h"
#include "recon/core/progress.h"
#include "recon/core/rigid_motion.h"
#include "recon/delaunay/reconstruct.h"
#include "recon/distance/db_reconstruction.h"
#include "recon/output/element_model.h"
#include "recon/output/report_json.h"

namespace odontoscope::app {

struct Model {
  Reconstruction reconstruction;
  /// One for each solid whose surface in `reconstruction` is a simplified one; the tetrahedra stay as they were.
  std::vector<StructureSimplification> simplifications;
  std::optional<SimplificationAim> aim;
  std::optional<ModelElements> elements;  // its surfaces and tetrahedra are these
};

/// A model with what its report tells of where it came from.
struct MadeModel {
  Model model;
  std::optional<ReportVolume> volume;
};

/// The program's report on it.
std::string report_of(const MadeModel& made);

/// As simplify_surfaces (recon/output/simplify_model.h) does.
void simplify_model(Model& model, std::size_t triangles, const Progress& progress);

/// Of --elements, mm; nothing for "quality". UsageError for anything else.
std::optional<double> element_size_from(const std::string& text);

/// As mesh_elements (recon/output/element_model.h) does.
void mesh_model(Model& model, std::optional<double> size, const Progress& progress);

/// Moves surfaces and tetrahedra. Coordinates are rounded anew: InputError turned-flat if that turns a tetrahedron over
/// or makes it flat, or spoils a surface.
void move_model(Model& model, const RigidMotion& motion);

/// "2,582 triangles are left, not 283: ..."; empty if what was asked for was reached.
std::string missed_aim_in_words(const SimplificationAim& aim);
/// Of structures that are off by an absurd part of their size, what to know of it; else empty.
std::string absurd_distance_in_words(const std::vector<StructureSimplification>& simplifications);

/// Shells, genus, volume, triangles, tetrahedra, seconds, and what is certified, in plain words.
void tell_model(const Model& model, double seconds, Console& console);
/// The same of a DB model, and what is wrong with it.
void tell_model(const DbReconstruction& model, double seconds, Console& console);

}  // namespace odontoscope::app
