#pragma once
// Generated human teeth: contour stacks with known truth, for the first run, for tests and for teaching.
//
// Three permanent teeth, each a smooth implicit shape cut into slices:
//   molar     lower left first molar (FDI 36): two roots, three canals, five cusps with the Y-shaped fissure pattern
//   premolar  upper right first premolar (FDI 14): buccal and lingual root, two canals, two cusps
//   incisor   upper right central incisor (FDI 11): one root, one canal, incisal edge, cingulum and lingual fossa
//
// Proportions: the table of average tooth dimensions in S. J. Nelson and M. M. Ash, "Wheeler's Dental Anatomy,
// Physiology, and Occlusion" (see `Proportions`). Root trunk of the molar: biometric study of 96 lower first molars
// (3.07 +- 0.82 mm buccal, 3.54 +- 0.73 mm lingual). Pulp chamber: A. S. Deutsch and B. L. Musikant, Journal of
// Endodontics 30(6), 2004, 388-390 (lower molars: floor to furcation 2.96 +- 0.78 mm, height 1.57 +- 0.68 mm).
// docs/sample-teeth.md tells where the model keeps to them and where not.
//
// Axes (right-handed, mm): x mesiodistal with +x mesial, y buccolingual (labiolingual) with +y buccal (labial), z along
// the tooth, apex low at z = 0, cusps high. The cervix lies near x = y = 0.
//
// Not supported: wear, accessory canals, cementum (counted as dentine).

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/core/named.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

enum class ToothKind { molar, premolar, incisor };

/// "molar", "premolar", "incisor".
inline constexpr NameTable<ToothKind, 3> tooth_kinds{
    {{"molar", ToothKind::molar}, {"premolar", ToothKind::premolar}, {"incisor", ToothKind::incisor}}};
inline const char* name(ToothKind kind) { return word_of(tooth_kinds, kind); }

/// How enamel, dentine and pulp lie beside each other in a slice.
enum class SampleWalls {
  shared,  // neighbours share their border, to the bit: what a label map gives, and what a partition (recon/partition)
           // is made of
  apart,   // a gap of limits::sample_gap keeps enamel off dentine and dentine off pulp
  filled   // every structure is filled and so overlaps those within it
};

struct SampleOptions {
  /// Distance of neighbouring slices, mm; the first lies half of it above the lowest apex. 0.05 to 0.35: beyond, the
  /// ends of canals and horns would come off. Not given: closer where the shape changes most along z (apices, floor and
  /// roof of the chamber, cervical line, fissures and cusps), wider between.
  std::optional<double> slice_spacing = {};
  /// Largest distance of neighbouring points of a contour, mm, 0.05 to 1. Small contours and sharp bends get closer
  /// points.
  double point_spacing = 0.22;
  SampleWalls walls = SampleWalls::shared;
  /// Only where structures keep apart. true: the dentine has the pulp cavity as holes and is complete by itself. false:
  /// it is filled, for reconstructing dentine and pulp together (where the pulp's contours become the holes).
  bool hollow_dentine = true;
  /// true: every canal narrows to its constriction, 0.75 mm above the apex, and leaves the root through a foramen,
  /// where the pulp meets the outside. false: it ends blind 0.5 mm above the apex.
  bool open_apex = false;
};

/// Contours of the structures "enamel", "dentine" and "pulp", slices by ascending z. Passes `validate`. Contours are
/// simple and, within a structure, at least limits::sample_clearance apart, but where a margin runs out to nothing.
/// Outer contours are counter-clockwise seen from +z, holes clockwise. Coordinates are rounded to limits::sample_grain,
/// but for the few points where contours of two structures cross.
///
/// Topology: enamel one shell of genus 0 (a cap), dentine one of genus 0 with one cavity of genus 0 (none if not
/// hollow), pulp one of genus 0; with open apices the dentine is one shell without a cavity, of a genus one less than
/// the canals are. So they come out of `reconstruct` at the default spacing. Not promised at every other:
/// between two slices a fissure's bottom or the edge of the chamber's floor may be narrower than a slab can hold, which
/// adds a small handle to the enamel or the cavity. The same options give the same stack, byte for byte. Throws
/// UsageError for options out of range.
ContourStack sample_tooth(ToothKind kind, const SampleOptions& options = {});

/// Dimensions of the average tooth after Wheeler, mm. "Buccolingual" is labiolingual for the incisor.
struct Proportions {
  double crown_length = 0, root_length = 0;
  double crown_mesiodistal = 0, cervix_mesiodistal = 0;
  double crown_buccolingual = 0, cervix_buccolingual = 0;
  /// How much further towards the cusps the cervical line runs on that side than on the buccal.
  double cervical_curve_mesial = 0, cervical_curve_distal = 0;
};

struct NamedPoint {
  std::string name;
  Point3 at;
};

struct CanalFact {
  std::string name;              // "mesiobuccal", "mesiolingual", "distal"; "buccal", "lingual"; "root canal"
  std::string root;              // the root that it runs in
  double low_z = 0, high_z = 0;  // from its blind end to its orifice in the pulp chamber
  std::vector<Point3>
      axis;  // centre line from the blind end up to the orifice, one point every half millimetre or less
};

/// What is true of a sample tooth by construction, whatever the options.
struct SampleFacts {
  ToothKind kind = ToothKind::molar;
  std::string tooth;        // "lower left first molar (FDI 36)"
  std::string fdi;          // two-digit tooth number
  Proportions proportions;  // what the shape was modelled on
  double cervix_z = 0;      // of the cervical line where it is lowest
  double top_z = 0;         // of the highest cusp or edge
  double furcation_z = 0;   // roof of the furcation between the roots; cervix_z if there is one root
  double chamber_low_z = 0, chamber_high_z = 0;  // floor and roof of the pulp chamber, without horns
  std::vector<NamedPoint> roots;                 // with their apex
  std::vector<NamedPoint> cusps;                 // with their tip; the ends of the incisal edge for the incisor
  std::vector<NamedPoint> horns;                 // pulp horns, with their tip
  std::vector<CanalFact> canals;
};

SampleFacts sample_facts(ToothKind kind);

}  // namespace odontoscope
