#pragma once
// Centre lines of a void: from the middle of the pulp chamber down each canal to its end.
//
// The 3D Delaunay triangulation of the wall's vertices knows the void's medial structure: the circumcentres inside the
// void lie far from all walls, and neighbours make a graph (the inner Voronoi diagram; N. Amenta, M. Bern, "Surface
// reconstruction by Voronoi filtering", 1999). Lines are shortest paths in it where every millimetre costs as much as
// it is narrow (one over the radius squared), to the ends that lie farthest from the chamber and are long compared with
// their width (after M. Sato et al., "TEASAR: tree-structure extraction algorithm", 2000). They are then centred
// against the wall's triangles, and smoothed.
//
// Deterministic: the same wall gives the same bytes, on any number of threads. Units: millimetres.
//
// Not supported: a void without any width to speak of between its ends (a crack) gets a line along its middle surface
// that is not unique.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/cavity/cavity.h"
#include "recon/core/geometry.h"
#include "recon/core/progress.h"
#include "recon/mesh/vector.h"

namespace odontoscope {

struct CentrePoint {
  Point3 at;
  double radius = 0;  // clearance: distance to the nearest place of the wall's triangles
  double along = 0;   // length of the line from its start
  double ball = 0;  // of the widest ball in the cross-section beside it: a smooth line cuts corners, where `radius` is
                    // a little less
};

/// Points are evenly spaced, at least two. Straight lines between them stay in the void.
struct CentreLine {
  std::string name;  // "canal 1", or as the anatomy knows it: see canal_names.h
  std::vector<CentrePoint> points;
  /// Of `points`: where a canal leaves the chamber; 0 if there is none, or for a horn. That is where the section across
  /// the line shrinks most within one radius; without a distinct floor (an incisor) where the line leaves the chamber's
  /// ball.
  std::size_t orifice = 0;
  Point3 end;    // on the wall, where the line meets it if carried on straight
  Point3 start;  // the same of a line that begins at a blind end; else its first point

  /// What is called a canal's length everywhere: along the line from the orifice (of a tube without a chamber, from the
  /// wall at its beginning) to the wall at its end.
  double length_to_wall() const;
  bool starts_blind() const { return !(start == points.front().at); }
};

struct CentreLines {
  Point3 chamber;             // its centre; where there is no chamber (a tube), the middle of its wide part
  double chamber_radius = 0;  // clearance there
  bool has_chamber = true;
  /// Longest line first, from where it begins (not from the orifice, as a canal's length is told), ties by the end's
  /// coordinates; names are "canal 1", "canal 2", ... in that order. Each begins in the chamber's centre, or, without a
  /// chamber, at the crown's end of the tube. Canals that fork have their first part in common, canals that join their
  /// last. There are as few as lead through everything: where canals join and part again, which of the upper goes on to
  /// which of the lower is a choice.
  std::vector<CentreLine> canals;
  /// Branches towards the crown ("horn 1", ...), and those that are too short to be canals, against the longest or
  /// their own width ("branch 1", ...), but for short forks (see forks.h); ordered alike. Last, what joins two canals
  /// that both go on ("isthmus 1", ...): from the chamber down the one and through, to where it meets the other.
  std::vector<CentreLine> horns, others;
  /// Of a void with handles the lines round each that is half as wide as a canal: closed, the last point is the first
  /// ("loop 1", ...).
  std::vector<CentreLine> loops;
};

struct CentreLineOptions {
  /// Along the tooth, towards the crown or away from it: which, is told by the longest branch, a canal. Branches
  /// towards the crown are horns. Nothing: all branches are canals.
  std::optional<Direction> axis = Direction{0, 0, 1};
};

/// Precondition: the wall is a closed oriented manifold without self-intersections. Throws UsageError if it is no such
/// manifold. A void that is too round to have branches has no lines; chamber and radius are told all the same. A crack
/// that no ball fits in has a radius of 0. Runs in the caller's TBB arena. Stage: "centre lines".
CentreLines centre_lines(const Cavity& cavity, const CentreLineOptions& options = {}, const Progress& progress = {});

}  // namespace odontoscope
