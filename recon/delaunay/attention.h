#pragma once
// What a certified model asks a person to look at, and what was changed on the way. `reconstruct` fills it, verdict.h
// judges and words them.

#include <cstddef>
#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/input/links.h"

namespace odontoscope {

/// Betti numbers of a solid.
struct Topology {
  long pieces = 0;   // connected components
  long handles = 0;  // independent loops
  long bubbles = 0;  // voids that are shut in
  long euler() const { return pieces - handles + bubbles; }
  friend bool operator==(const Topology&, const Topology&) = default;
};

/// Why a place deserves a look, the weightiest first.
enum class AttentionKind {
  choice,       // the data leave open what connects to what
  gap,          // pieces of one structure end, facing each other, on neighbouring slices: a bead, or two things
  void_gap,     // the same of voids: a canal or a chamber with a wall of one slab's height in it
  topology,     // a slab's solid has other pieces, handles or bubbles than its contours and links imply
  loose_piece,  // a piece that only few slices hold
};

/// One place to look at. Slices count by ascending z from 0, as links do.
struct Attention {
  AttentionKind kind = AttentionKind::topology;
  std::string structure;
  std::size_t slice = 0, last_slice = 0;  // it lies between these two, or in them
  double z_lower = 0, z_upper = 0;        // heights of these, mm
  Point3 place;                           // about where, mm
  Topology expected, found;               // of the structure's solid in the slab above `slice`; at the last: below
  std::string seen;                       // one or two sentences
  std::vector<Link> links;                // any one of these decides it: connected, or kept apart; the nearest first
  std::string remedy;                     // a sentence; empty: nobody but who knows the tooth can tell
};

/// Where the solid between two slices is not what Delaunay's triangulation of the two gave.
struct SlabChange {
  enum class Kind {
    trimmed,       // tetrahedra that leaned far over nothing were taken out
    raised,        // lifting found no room, and the slab's triangulation was moved off both slices
    interpolated,  // slices were interpolated between the two
  };
  Kind kind = Kind::trimmed;
  std::string structure;
  std::size_t slice = 0;            // the lower one
  double z_lower = 0, z_upper = 0;  // mm
  Point3 place;                     // mm: of the largest tetrahedron trimmed, or the middle of the slab's solid
  double volume = 0;                // mm^3: of what was trimmed, or of the slab's solid
  std::size_t count = 0;            // tetrahedra trimmed, or slices interpolated; else 0
};

const char* name(AttentionKind kind);
const char* name(SlabChange::Kind kind);

}  // namespace odontoscope
