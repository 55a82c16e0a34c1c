#pragma once
// A tooth in numbers: its structures, its canals, its roots. Units: millimetres and degrees; z runs along the tooth.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/cavity/canal_graph.h"
#include "recon/cavity/canal_shape.h"
#include "recon/cavity/cavity.h"
#include "recon/cavity/centre_lines.h"
#include "recon/cavity/isthmus.h"
#include "recon/cavity/tooth_axis.h"

namespace odontoscope {

struct MeasuredStructure {
  std::string name;
  double volume = 0;  // of the material: cavities are taken off, mm^3
  double area = 0;    // of its outside, mm^2
};

struct MeasuredPlace {
  double width = 0;
  Point3 at;
};

/// How far a canal's figures may be off because it was cut into slices: see uncertainty.h. In their units.
struct CanalUncertainty {
  double length = 0, schneider_deg = 0, smallest_bend = 0, mean_width = 0, narrowest = 0, thinnest_wall = 0;
  std::array<double, 3> volume{}, area{};  // of thirds
  std::vector<double> apical_width, apical_area;
};

struct MeasuredCanal {
  std::string name;
  Point3 orifice, end;
  double length = 0;  // CentreLine::length_to_wall
  /// S. W. Schneider, "A comparison of canal preparations in straight and curved root canals", 1971, in space: between
  /// the canal's long axis (from the orifice through the line's point after a third of the length) and the straight
  /// line from where the centre line leaves that axis by more than half its local radius to the end. 0 if it never
  /// does.
  double schneider_deg = 0;
  double smallest_bend = 0;  // radius, see bend.h; infinite if straight
  double bend_fit = 0;       // Bend::uncertainty
  /// Widths are those of the widest balls in the cross-sections, without narrow places shorter than slices are apart
  /// (known_widths), no nearer to a blind end than their median; nothing where all of the canal is as near.
  std::optional<MeasuredPlace> narrowest;
  double mean_width = 0;  // over the same part, so that it is not less than the narrowest; of all of the canal where
                          // there is no such part
  /// The least distance from the canal's wall to the outside of the solid that it runs in; nothing if that solid is not
  /// there. Not looked for nearer to a mouth than the mean width, nor beside an orifice (limits::orifice_rim).
  std::optional<MeasuredPlace> thinnest_wall;
};

/// Vertucci's types (F. J. Vertucci, "Root canal anatomy of the human permanent teeth", 1984) by the number of separate
/// sections of the root's canals, from just below the lower orifice to just above the first blind end: 1 is I, 2-1 II,
/// 1-2-1 III, 2 IV, 1-2 V, 2-1-2 VI, 1-2-1-2 VII, 3 VIII. Canals joined by an isthmus only (limits::isthmus_wide) are
/// separate. Runs shorter than the mean width are left out. No height between the two ends: no sections, "other".
struct MeasuredRoot {
  std::vector<std::size_t> canals;    // of Anatomy::canals
  std::vector<std::size_t> sections;  // counts, from the orifice to the apex, whichever of them is up
  std::string vertucci;               // "I" to "VIII", or "other"
  /// Of CentreLines::others, those that end beside its canals: accessory canals, or the tips of a fin. Sections do not
  /// count them.
  std::size_t uncounted = 0;
  std::vector<Isthmus> isthmuses;
};

/// H. M. A. Ahmed, M. A. Versiani, G. De-Deus, P. M. H. Dummer, "A new system for classifying root and root canal
/// morphology", 2017: the number of roots above, the tooth's number, for which TN stands, and for each root the course
/// of its canals from orifice over canal to foramen: \u00b9TN\u00b9\u207b\u00b2. Of several roots, which is buccal or
/// mesial is not known: they are R\u2081, R\u2082 in the order of `roots`. Without accessory canals. Empty if a root is
/// too short, or there is none.
std::string ahmed_code(const std::vector<MeasuredRoot>& roots);

/// A branch that leaves a canal below its orifice, with material in between, and is no canal by itself: too short or
/// thin, or it runs sideways. The tips of a fin are none. Whether it reaches the outside is not asked. H. M. A. Ahmed,
/// P. Neelakantan, P. M. H. Dummer, "A new system for classifying accessory canal morphology", 2018, tells them by the
/// third of the canal that they leave from.
struct AccessoryCanal {
  std::string name;       // of the line
  std::size_t canal = 0;  // that it leaves
  std::size_t third = 0;  // of that: 0 coronal, 1 middle, 2 apical
  Point3 from, end;       // where material is between first, and the wall at its end
  double length = 0, mean_width = 0;
};

/// One for each part of the canals' graph.
struct MeasuredPart {
  double length = 0;      // along the line; to the wall where it ends there
  double mean_width = 0;  // twice the mean clearance
};

/// Where a canal's wall and the outside of the tooth are one: no thin wall, but none.
struct Opening {
  std::size_t canal = 0;  // of Anatomy::canals
  Point3 at;
  double reach = 0;  // to the farthest such place that belongs to it
};

/// Closed shells beside the largest void, in the same structure: a pulp that falls to pieces, or bubbles. They are not
/// measured.
struct LoosePieces {
  std::size_t count = 0;
  double volume = 0, largest = 0;  // of all; of the largest, mm^3
};

struct Anatomy {
  std::vector<MeasuredStructure> structures;
  ToothAxis axis;                             // along which horns, roots and sections are told
  std::string cavity_of;                      // structure; empty: there is no void, and nothing below
  double cavity_volume = 0, cavity_area = 0;  // of one that is open, as closed by its caps
  std::vector<Cavity::Mouth> mouths;          // where it opens to the outside, if it does
  double chamber_width = 0;                   // twice the clearance in its centre
  std::vector<MeasuredCanal> canals;
  std::vector<CanalShape> shapes;  // one a canal
  std::vector<AccessoryCanal> accessory_canals;
  double slice_spacing = 0;                     // of the given slices, or told from the wall, see uncertainty.h
  std::vector<CanalUncertainty> uncertainties;  // one a canal
  std::size_t horns = 0, other_branches = 0;
  /// Of the void: canals that join again, or what stands in the chamber, where not 0; those that CentreLines::loops
  /// lead round.
  std::size_t handles = 0;
  /// The rest of its genus: handles narrower than half a canal, as they come about between two slices. Not counted
  /// above.
  std::size_t narrow_handles = 0;
  LoosePieces loose;
  std::vector<Opening> openings;  // a canal's thinnest wall is looked for away from them, no nearer than its mean width
  /// Canals that lie in the same outer contour half way along the shorter one's apical half share a root. Empty where
  /// the outside is not there.
  std::vector<MeasuredRoot> roots;
  CanalGraph graph;  // what canals share
  std::vector<MeasuredPart> parts;
  CentreLines lines;  // what all this was measured along; canals in the same order
};

/// Of the largest void of `model`, or pocket (see cavity.h). Not measured: open shells. Deterministic. Stages: those of
/// centre_lines, "measure". `slices`: how many the whole model was made from, from its lowest place to its highest, if
/// that is known: a wall alone does not tell slices from those that were interpolated between them.
Anatomy measure_anatomy(const std::vector<StructureSurface>& model, const Progress& progress = {},
                        std::optional<std::size_t> slices = {});

}  // namespace odontoscope
