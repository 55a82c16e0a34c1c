#pragma once
// A tooth in numbers: its structures, its canals, its roots. Units: millimetres and degrees; z runs along the tooth.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/cavity/canal_graph.h"
#include "recon/cavity/cavity.h"
#include "recon/cavity/centre_lines.h"

namespace odontoscope {

struct MeasuredStructure {
  std::string name;
  double volume = 0;   // of the material: cavities are taken off, mm^3
  double area = 0;     // of its outside, mm^2
};

struct MeasuredPlace {
  double width = 0;
  Point3 at;
};

struct MeasuredCanal {
  std::string name;
  Point3 orifice, end;
  double length = 0;            // along the centre line, from the orifice to the wall at its end
  /// S. W. Schneider, "A comparison of canal preparations in straight and curved root canals", 1971, in space: between the canal's long axis (from the
  /// orifice through the line's point after a third of the length) and the straight line from where the centre line leaves that axis by more than half its
  /// local radius to the end. 0 if it never does.
  double schneider_deg = 0;
  double smallest_bend = 0;     // smallest radius of curvature, over a window of the mean width to either side; infinite if straight
  /// Twice the least clearance, no nearer to a blind end than the mean width; nothing where all of the canal is as near.
  std::optional<MeasuredPlace> narrowest;
  double mean_width = 0;        // twice the mean clearance over the length
  /// The least distance from the canal's wall to the outside of the solid that it runs in; nothing if that solid is not there. Not looked for nearer to a
  /// mouth than the mean width.
  std::optional<MeasuredPlace> thinnest_wall;
};

/// Vertucci's types (F. J. Vertucci, "Root canal anatomy of the human permanent teeth", 1984) by the number of separate sections of the root's canals, from
/// just below the lower orifice to just above the first blind end: 1 is I, 2-1 II, 1-2-1 III, 2 IV, 1-2 V, 2-1-2 VI, 1-2-1-2 VII, 3 VIII. Runs shorter
/// than the mean width are left out. No height between the two ends: no sections, "other".
struct MeasuredRoot {
  std::vector<std::size_t> canals;     // of Anatomy::canals
  std::vector<std::size_t> sections;   // counts, from the orifice to the apex, whichever of them is up
  std::string vertucci;                // "I" to "VIII", or "other"
  /// Of CentreLines::others, those that end beside its canals: the ends of a short fork, or the tips of a fin. Sections do not count them.
  std::size_t uncounted = 0;
};

/// One for each part of the canals' graph.
struct MeasuredPart {
  double length = 0;       // along the line; to the wall where it ends there
  double mean_width = 0;   // twice the mean clearance
};

struct Anatomy {
  std::vector<MeasuredStructure> structures;
  std::string cavity_of;               // structure; empty: there is no void, and nothing below
  double cavity_volume = 0, cavity_area = 0;   // of one that is open, as closed by its caps
  std::vector<Cavity::Mouth> mouths;   // where it opens to the outside, if it does
  double chamber_width = 0;            // twice the clearance in its centre
  std::vector<MeasuredCanal> canals;
  std::size_t horns = 0, other_branches = 0;
  long handles = 0;                    // of the void: canals that join again, or what stands in the chamber, where not 0
  /// Canals that lie in the same outer contour half way along the shorter one's apical half share a root. Empty where the outside is not there.
  std::vector<MeasuredRoot> roots;
  CanalGraph graph;                    // what canals share
  std::vector<MeasuredPart> parts;
  CentreLines lines;                   // what all this was measured along; canals in the same order
};

/// Of the largest void of `model`, or dent (see cavity.h). Not measured: open shells. Deterministic. Stages: those of centre_lines, "measure".
Anatomy measure_anatomy(const std::vector<StructureSurface>& model, const Progress& progress = {});

}  // namespace odontoscope
