#pragma once
// The DT engine: a stack of contours to a tetrahedral solid whose boundary is a certified, closed, oriented manifold.
//
// After section 3.2 of "Qualitative analysis of two reconstruction techniques and their application in dentistry"
// (Journal of Electronic Imaging 9(4), 2000), with the gaps of that text closed as docs/reconstruction.md describes.
//
// What holds for every valid stack: all tetrahedra are positive; each face belongs to at most two; the boundary is
// closed, oriented outwards, edge- and vertex-manifold; the solid cut by a slice's plane is exactly that slice's
// regions. It is proven on the result each time; a failed proof throws InternalError.
//
// The same input gives the same bytes, on any number of threads.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/named.h"
#include "recon/core/progress.h"
#include "recon/delaunay/attention.h"
#include "recon/delaunay/doubt.h"
#include "recon/input/links.h"
#include "recon/input/validate.h"
#include "recon/mesh/labelled_complex.h"
#include "recon/mesh/meshes.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope {

/// When are a region and one of the next slice connected? Each of the first three includes those before it.
enum class Correspondence {
  reverse,  // the paper's: a tetrahedron joins an internal, non-contour edge of each
  medial,   // or the circumcentre of an internal triangle of one lies in the other
  overlap,  // or any point of the common Voronoi overlay lies in both
  tracked,  // as medial; then what hangs free is linked by what the slices before and behind say (track.h)
};

/// What becomes of the space between two slices?
enum class Between {
  blended,   // slices are interpolated where a slab needs it, and the topology that contours and links imply is sought
  delaunay,  // the paper's: the Delaunay triangulation of the two slices alone
};

struct ReconstructOptions {
  Correspondence correspondence = Correspondence::tracked;
  Between between = Between::blended;
  std::vector<Link> links;  // the user's choices; validated by reconstruct
  int threads = 0;          // 0: as many as the machine has
};

/// Why a link was made. `user`: the links file; `crossing`: the two components would otherwise have crossed each other
/// and were therefore made one.
enum class LinkCriterion { reverse, medial, overlap, user, crossing, tracked };

struct MadeLink {
  Link link;
  LinkCriterion criterion = LinkCriterion::medial;
};

/// A void of one slice joined with one of the next; a void is named by the hole contour that bounds it.
struct MadeVoidLink {
  std::string structure;
  std::size_t slice = 0;
  std::optional<std::size_t> lower, upper;  // number of the hole's contour in its slice; none: the outside
  LinkCriterion criterion = LinkCriterion::medial;
};

/// One structure's solid between two slices: what its contours and links imply (docs/reconstruction.md), and what was
/// counted.
struct SlabTopology {
  std::string structure;
  std::size_t slice = 0;  // the lower one
  Topology implied, found;
  std::size_t interpolated = 0;       // slices that were put between the two
  bool raised = false;                // see ReconstructCounts::raised_slabs
  std::optional<Topology> untrimmed;  // what it was before overhangs were trimmed in it; empty: none were
  Point3 place;                       // if not as implied: about where
  /// Trimming leaves a region flat in its slice and keeps the topology of the whole (overhang.h), so what it was before
  /// counts.
  bool as_implied() const { return implied == untrimmed.value_or(found); }
};

struct StageTime {
  std::string stage;
  double seconds = 0;
};

/// One structure as a solid of its own.
struct Solid {
  std::string structure;
  TetraMesh tetrahedra;  // points: slice by slice, then those added by lifting
  SurfaceMesh surface;   // boundary of `tetrahedra`; points are a subset, in the same order
  SurfaceReport report;  // of `surface`; its shells carry structure names
};

struct ReconstructCounts {
  std::size_t slices = 0, contours = 0, points = 0, steiner_points = 0;
  std::size_t kept = 0;      // tetrahedra of the result
  std::size_t restored = 0;  // that repair put back, before they were split
  std::size_t lifted_points = 0;
  std::size_t trimmed = 0;           // taken out where regions hang over nothing
  std::size_t cut_links = 0;         // witnessed, but not built: the solids would have crossed one that must stay apart
  std::size_t isolated_regions = 0;  // linked to nothing on either side: made a thin plate
  std::size_t raised_slabs = 0;      // where lifting found no room, and the triangulation was moved off both slices
  std::size_t constrained_slices =
      0;  // whose contours could not be made Delaunay, and whose slabs are blocks therefore (block.h)
  double largest_sideways = 0;  // of a lifted point, over the length of the edge that it split
};

/// What making a partition took (recon/partition); all 0 for structures reconstructed by themselves.
struct PartitionCounts {
  std::size_t crossings = 0;      // points where contours of two structures cross
  std::size_t corners_cut = 0;    // where four faces or more met in a point of a slice
  double closed_gap = 0;          // area of void given to structures, over all slices, mm^2
  std::size_t raised_points = 0;  // moved off their slice, since what its faces claim contradicts the next slice
  std::size_t relabelled = 0;     // tetrahedra, to mend what was singular
  std::size_t patches = 0;        // neighbourhoods that got one label for the same reason
  std::size_t cut_slabs = 0;      // whose slices could not be made Delaunay: every face ends just off them
};

struct Reconstruction {
  std::vector<Solid> solids;             // in order of first appearance of the structure
  std::vector<MadeLink> links;           // by structure, slice, lower, upper
  std::vector<MadeVoidLink> void_links;  // by structure, slice, lower, upper
  std::vector<SlabTopology> topology;    // of every slab that holds material, by structure and slice
  std::vector<SlabChange> changes;       // by structure, slice and kind
  std::vector<Attention> attention;      // where to look, see verdict.h
  std::vector<Doubt> doubts;             // choices that the slices do not settle; by structure, slab, lower, upper
  std::vector<Link> remedies;  // tried: each joins a region that is linked to nothing; for the first few of these
  /// Of a partition (recon/partition): what the solids share. Empty: each structure was reconstructed by itself.
  std::optional<LabelledComplex> complex;
  PartitionCounts partition;
  ReconstructCounts counts;
  std::vector<StageTime> seconds;
  int threads = 1;
  std::size_t slices_checked = 0;  // whose section was proven to be exactly the slice's regions
  bool certified = false;          // always true on return
};

/// Validates `stack` and `options.links` (InputError), reconstructs every structure independently, and certifies the
/// result. Throws Cancelled, or InternalError if a certificate fails.
Reconstruction reconstruct(const ValidStack& stack, const ReconstructOptions& options = {},
                           const Progress& progress = {});
/// Validates it first.
Reconstruction reconstruct(const ContourStack& stack, const ReconstructOptions& options = {},
                           const Progress& progress = {});

inline constexpr NameTable<Between, 2> ways_between{{{"blended", Between::blended}, {"delaunay", Between::delaunay}}};
inline const char* name(Between between) { return word_of(ways_between, between); }
inline constexpr NameTable<Correspondence, 4> correspondences{{{"reverse", Correspondence::reverse},
                                                               {"medial", Correspondence::medial},
                                                               {"overlap", Correspondence::overlap},
                                                               {"tracked", Correspondence::tracked}}};
inline const char* name(Correspondence criterion) { return word_of(correspondences, criterion); }
const char* name(LinkCriterion criterion);

}  // namespace odontoscope
