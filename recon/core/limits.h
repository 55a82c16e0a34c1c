#pragma once
// Every limit and tolerance of `recon`, each with its reason. Nothing else in the library compares with a bare number.

#include <cstddef>

namespace odontoscope::limits {

// --- sizes of what is read ---------------------------------------------------------------------------------------
/// Largest coordinate, mm. A tooth is 30 mm long; a patient 2 m. Beyond this a file surely has the wrong unit, and the
/// exact predicates' filters stay far from overflow.
inline constexpr double largest_coordinate = 1e6;
/// Slices in a stack: ten times the largest micro-CT scan.
inline constexpr std::size_t slices = 20'000;
/// Contours in a slice.
inline constexpr std::size_t contours_per_slice = 10'000;
/// Contours in a stack: bounds the memory of a file that is all empty contours.
inline constexpr std::size_t contours = 10'000'000;
/// Points in a stack: 32-bit vertex numbers stay safe with Steiner points and lifted points added.
inline constexpr std::size_t points = 100'000'000;
/// Structures (names) in a stack: labels are 16 bit.
inline constexpr std::size_t structures = 1'000;
/// Characters in a name.
inline constexpr std::size_t name_length = 200;
/// Bytes of a name that a message repeats.
inline constexpr std::size_t quoted_length = 40;
/// Bytes of a single text, number or gap in a JSON file: bounds what its parser holds.
inline constexpr std::size_t json_token = 1 << 20;
/// Levels of brackets in notes ("x-..." keys) that are skipped.
inline constexpr std::size_t json_depth = 64;
/// Bytes that are read from a file at once.
inline constexpr std::size_t read_piece = 1 << 16;
/// Links in a links file: more than any stack within the limits above has use for.
inline constexpr std::size_t links = 10'000'000;
/// Triangles of a mesh that is read: 32-bit half-edge numbers stay safe.
inline constexpr std::size_t triangles = 100'000'000;
/// Bytes of the JSON part of a GLB, which takes some twenty times that when parsed.
inline constexpr std::size_t gltf_json_bytes = 64u << 20;
/// Characters in a line of a text header.
inline constexpr std::size_t text_line = 10'000;
/// Bytes of a text or mesh file that is read whole.
inline constexpr std::size_t file_bytes = 4ull << 30;
/// Voxels of a volume: 2 GiB of 16 bit.
inline constexpr std::size_t voxels = 1ull << 30;

}  // namespace odontoscope::limits

// --- the DT engine -----------------------------------------------------------------------------------------------
namespace odontoscope::limits {
/// A gap between contours is narrow where an edge along it is this many times as long as the gap is wide.
inline constexpr double narrow_gap = 16;
/// Points that conforming may leave in a slice, as a multiple of those given plus a free allowance: contours that nearly touch
/// need many, the more so the nearer to the precision of a double.
inline constexpr std::size_t steiner_factor = 50;
inline constexpr std::size_t steiner_free = 10'000;
/// Rounds of splitting contour edges: each halves what is too long, so this spans the whole precision of a double.
inline constexpr int conform_rounds = 64;
/// Sine below which a tetrahedron counts as flat: points added on a straight contour edge are off it by a rounding, and make hull triangles
/// about 1e-16 thin.
inline constexpr double flat_share = 1e-10;
/// Height that is tried first for a lifted point, over the slab's height: points lifted from both slices stay apart.
inline constexpr double lift_height = 0.5;
/// Share of the step that fits which is really taken; no simple fraction, so that split points do not fall on planes through others.
inline constexpr double lift_margin = 0.618;
/// Times that the step of a lifted point is halved before the next direction is tried.
inline constexpr int lift_halvings = 40;
/// How far a lifted point may go sideways, over the length of the edge that it splits.
inline constexpr double lift_sideways = 0.5;
/// How far a tetrahedron may lean out over nothing, over half the width of the region that it hangs from: two widths.
inline constexpr double overhang = 4;
/// Thickness of the plate that an isolated region becomes, over the slab's height, before it is halved to keep clear of others.
inline constexpr double plate_height = 0.25;
inline constexpr int plate_halvings = 60;
// --- following shapes over several slices --------------------------------------------------------------------------
/// How far apart two sections of one thing may lie: so many times the sum of their radii, and this much over the height between them.
/// Circles shifted by three radii are within, and a hair-thin canal at 45 degrees; beyond, anything could be meant.
inline constexpr double track_reach_sizes = 2;
inline constexpr double track_reach_slope = 1;
/// Times that a section's radius may change from one slice to the next and still be taken for the same thing.
inline constexpr double track_size_ratio = 2;
/// Ends within reach of one end beyond which it stands in a clutter where nothing is told apart.
inline constexpr std::size_t track_candidates = 16;
/// Expected number of lines as steady, or of hits as near, among shapes strewn by chance: below the first it is no chance, below the second
/// a line is worth asking about. A link whose chance is not well below the first is doubtful.
inline constexpr double track_chance = 0.05;
inline constexpr double track_chance_doubtful = 0.2;
inline constexpr double track_chance_clear = 0.02;
/// A miss smaller than this share of the reach says no more than one of this size: contours are drawn no better.
inline constexpr double track_precision = 0.1;
/// A miss larger than this share of the reach is a bend that no steady thing makes.
inline constexpr double track_bend = 0.5;
/// Share of a section that, moved on by its drift, must lie in a region for the two to be joined; and beyond which that is clear.
inline constexpr double track_entry = 0.5;
inline constexpr double track_entry_clear = 0.75;
inline constexpr double track_entry_doubtful = 0.25;
/// Area that a section is bound to have in the next slice, over its own, below which it is running out: tips and apices do.
inline constexpr double track_taper = 0.5;
/// Share of the smaller of two sections that must overlap: what a circle moved by 1.75 radii still covers; and beyond which that is clear.
inline constexpr double track_overlap = 0.05;
inline constexpr double track_overlap_clear = 0.15;
/// Rounds of linking steady lines, each of which leaves fewer ends to choose from; two or three are needed.
inline constexpr int track_rounds = 16;
// --- reports ----------------------------------------------------------------------------------------------------
/// Bins of a quality histogram.
inline constexpr std::size_t histogram_bins = 10;
/// The best smallest angle of a triangle, degrees.
inline constexpr double angle_histogram_high = 60;
/// Shape ratios beyond this fall into the last bin: such elements are all equally bad for any use.
inline constexpr double aspect_histogram_high = 11;
inline constexpr double dihedral_histogram_high = 180;
inline constexpr double radius_edge_histogram_high = 10;
/// A shape ratio that is larger, or not finite after rounding, counts as this.
inline constexpr double largest_aspect_ratio = 1e15;

// --- files that are written --------------------------------------------------------------------------------------
/// Bytes of a GLB's binary part: tinygltf counts in signed 32 bits.
inline constexpr std::size_t glb_bytes = (1ull << 31) - 1;

// --- simplifying ------------------------------------------------------------------------------------------------
/// How far round a place where the simplified surface went wrong the full one is kept, over the size of the triangles there.
inline constexpr double kept_margin = 0.25;

}  // namespace odontoscope::limits

// --- volume images -----------------------------------------------------------------------------------------------
namespace odontoscope::limits {
/// Smallest voxel spacing, mm: a nanometre, finer than any scanner; a 64th of it is still far above rounding at largest_coordinate.
inline constexpr double smallest_spacing = 1e-6;
/// How close an iso-contour comes to a pixel's centre, as a part of the grid edge: a contour through the centre itself would touch
/// its neighbours there. Far below what a scanner resolves, and large enough to keep conforming from refining without need.
inline constexpr double grid_vertex_margin = 1.0 / 64;
/// Largest label: floats hold all whole numbers up to 2^24, and none beyond is rounded to this one.
inline constexpr long largest_label = (1l << 24) - 1;
/// How far a volume's axes may be from square to each other (the dot product of two): headers round to six digits or so.
inline constexpr double axes_out_of_square = 1e-4;
/// Turn of a volume's axes, degrees, that is rounding of the header and not worth a word.
inline constexpr double tilt_unspoken = 0.01;
/// How unevenly DICOM slices may lie, as a part of their spacing: positions are written in thousandths or so.
inline constexpr double slice_unevenness = 0.02;
/// Most that the compressions of volume files shrink data (deflate: 1032 times); a header that asks for more than that lies.
inline constexpr std::size_t compression_ratio = 1100;
/// Bytes of a text header in front of a volume's pixels.
inline constexpr std::size_t header_bytes = 1u << 20;
/// Characters in a line of it: readers of old have buffers of 1,024 and more.
inline constexpr std::size_t header_line = 1000;
/// Sequences of DICOM within each other: real objects have four or so.
inline constexpr int dicom_nesting = 16;
}  // namespace odontoscope::limits

// --- sample teeth ------------------------------------------------------------------------------------------------
namespace odontoscope::limits {
/// Grid that a slice is sampled on, mm: a fifth of the narrowest canal.
inline constexpr double sample_grid = 0.06;
/// Half the side of that grid, mm: the largest tooth and a little more.
inline constexpr double sample_half_width = 6.3;
/// Contours of a smaller area, mm^2, are left out: the first touch of a fissure's bottom.
inline constexpr double sample_speck = 0.02;
/// How far a contour's chord may cut a curve, mm.
inline constexpr double sample_deviation = 0.006;
/// Between enamel and dentine, and dentine and pulp, mm: more than two such chords.
inline constexpr double sample_gap = 0.03;
/// Least distance of contours of a structure, mm, and the grain that coordinates are rounded to.
inline constexpr double sample_clearance = 1e-4;
inline constexpr double sample_grain = 1e-5;
/// Ranges of the options, mm: sections of neighbouring slices must overlap, and a stack stays below a million points.
inline constexpr double sample_least_slice_spacing = 0.05, sample_most_slice_spacing = 0.35;
inline constexpr double sample_least_point_spacing = 0.05, sample_most_point_spacing = 1.0;
}  // namespace odontoscope::limits
