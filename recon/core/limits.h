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
/// Corners of one face of a mesh: it is cut in memory, at some 300 bytes a corner.
inline constexpr std::size_t polygon_corners = 1'000'000;
/// How far the corners of a face may be off their plane, over its size, before it is called bent: files round to six or
/// seven digits.
inline constexpr double flat_polygon = 1e-4;
/// Bytes of the JSON part of a GLB, which takes some twenty times that when parsed.
inline constexpr std::size_t gltf_json_bytes = 64u << 20;
/// Characters in a line of a text header.
inline constexpr std::size_t text_line = 10'000;
/// Where sizes have 32 bits (WebAssembly) less fits into memory, and sums of sizes must not overflow.
inline constexpr bool small_sizes = sizeof(std::size_t) <= 4;
/// Bytes of a text or mesh file that is read whole.
inline constexpr std::size_t file_bytes = static_cast<std::size_t>(small_sizes ? 1ull << 30 : 4ull << 30);
/// Voxels of a volume: 2 GiB of 16 bit.
inline constexpr std::size_t voxels = small_sizes ? 1ull << 28 : 1ull << 30;

}  // namespace odontoscope::limits

// --- the DT engine -----------------------------------------------------------------------------------------------
namespace odontoscope::limits {
/// A gap between contours is narrow where an edge along it is this many times as long as the gap is wide.
inline constexpr double narrow_gap = 16;
/// Points that conforming may leave in a slice, as a multiple of those given plus a free allowance: contours that
/// nearly touch need many, the more so the nearer to the precision of a double.
inline constexpr std::size_t steiner_factor = 50;
inline constexpr std::size_t steiner_free = 10'000;
/// Rounds of splitting contour edges: each halves what is too long, so this spans the whole precision of a double.
inline constexpr int conform_rounds = 64;
/// Sine below which a tetrahedron counts as flat: points added on a straight contour edge are off it by a rounding, and
/// make hull triangles about 1e-16 thin.
inline constexpr double flat_share = 1e-10;
/// Height that is tried first for a lifted point, over the slab's height: points lifted from both slices stay apart.
inline constexpr double lift_height = 0.5;
/// Share of the step that fits which is really taken; no simple fraction, so that split points do not fall on planes
/// through others.
inline constexpr double lift_margin = 0.618;
/// Times that the step of a lifted point is halved before the next direction is tried.
inline constexpr int lift_halvings = 40;
/// How far the surface may travel sideways between two slices, over their distance, before slices are interpolated.
inline constexpr double steep = 0.5;
/// Height of the upright prisms of a raised slab, over the slab's height: a good third stays between the two layers.
inline constexpr double raise_height = 0.3;
/// How far a lifted point may go sideways, over the length of the edge that it splits.
inline constexpr double lift_sideways = 0.5;
/// How far a tetrahedron may lean out over nothing, over half the width of the region that it hangs from: two widths.
inline constexpr double overhang = 4;
/// Thickness of the plate that an isolated region becomes, over the slab's height, before it is halved to keep clear of
/// others. Less than raise_height, so that there is room beside raised pieces.
inline constexpr double plate_height = 0.25;
inline constexpr int plate_halvings = 60;

// --- what a person should look at --------------------------------------------------------------------------------
/// Gap between two ends that face each other across a slab, seen from above, over the width (root of the area) of the
/// smaller: a slanted canal that moves by more than its own width and another between two slices is not told from two.
inline constexpr double facing_gap = 1;
/// Slices that a loose piece has at most: what more of them hold is no accident of one slice.
inline constexpr std::size_t loose_slices = 3;

// --- following shapes over several slices --------------------------------------------------------------------------
/// How far apart two sections of one thing may lie: so many times the sum of their radii, and this much over the height
/// between them. Circles shifted by three radii are within, and a hair-thin canal at 45 degrees; beyond, anything could
/// be meant.
inline constexpr double track_reach_sizes = 2;
inline constexpr double track_reach_slope = 1;
/// Times that a section's radius may change from one slice to the next and still be taken for the same thing.
inline constexpr double track_size_ratio = 2;
/// Ends within reach of one end beyond which it stands in a clutter where nothing is told apart.
inline constexpr std::size_t track_candidates = 16;
/// Expected number of lines as steady, or of hits as near, among shapes strewn by chance: below the first it is no
/// chance, below the second a line is worth asking about. A link whose chance is not well below the first is doubtful.
inline constexpr double track_chance = 0.05;
inline constexpr double track_chance_doubtful = 0.2;
inline constexpr double track_chance_clear = 0.02;
/// A miss smaller than this share of the reach says no more than one of this size: contours are drawn no better.
inline constexpr double track_precision = 0.1;
/// A miss larger than this share of the reach is a bend that no steady thing makes.
inline constexpr double track_bend = 0.5;
/// Share of a section that, moved on by its drift, must lie in a region for the two to be joined; and beyond which that
/// is clear.
inline constexpr double track_entry = 0.5;
inline constexpr double track_entry_clear = 0.75;
inline constexpr double track_entry_doubtful = 0.25;
/// Area that a section is bound to have in the next slice, over its own, below which it is running out: tips and apices
/// do.
inline constexpr double track_taper = 0.5;
/// Share of the smaller of two sections that must overlap: what a circle moved by 1.75 radii still covers; and beyond
/// which that is clear.
inline constexpr double track_overlap = 0.05;
inline constexpr double track_overlap_clear = 0.15;
/// Rounds of linking steady lines, each of which leaves fewer ends to choose from; two or three are needed.
inline constexpr int track_rounds = 16;
/// Nearest regions of the next slice that are tried as a partner for one that is linked to nothing, and regions of a
/// structure, the first ones, for which that is done: advice, not work.
inline constexpr std::size_t remedies_tried = 2;
inline constexpr std::size_t regions_advised = 8;
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
/// How far round a place where the simplified surface went wrong the full one is kept, over the size of the triangles
/// there.
inline constexpr double kept_margin = 0.25;
/// Largest distance of a simplified surface, over the diagonal of the full one, beyond which it is said to be absurd:
/// at a twentieth, cusps and root tips are missing.
inline constexpr double absurd_distance = 0.05;

}  // namespace odontoscope::limits

// --- volume images -----------------------------------------------------------------------------------------------
namespace odontoscope::limits {
/// Smallest voxel spacing, mm: a nanometre, finer than any scanner; a 64th of it is still far above rounding at
/// largest_coordinate.
inline constexpr double smallest_spacing = 1e-6;
/// What contours of a volume lie on, mm: 2^-30, a picometre. Far below any scanner's precision, and a double still has
/// some 15 bits to spare for a tooth's coordinates, so that edges on it can be halved often without rounding.
inline constexpr double lattice_step = 1.0 / (1l << 30);
/// Such steps that a voxel has at least: its size is then changed by less than a millionth.
inline constexpr double lattice_steps_per_voxel = 1l << 20;
/// How close an iso-contour comes to a pixel's centre, as a part of the grid edge: a contour through the centre itself
/// would touch its neighbours there. Far below what a scanner resolves, and large enough to keep conforming from
/// refining without need.
inline constexpr double grid_vertex_margin = 1.0 / 64;
/// Smoothing of label maps. How far around a border voxels get a height, in voxels; and what the height is beyond.
inline constexpr int plate_reach = 2;
/// Steps down the plate's bending, and their length over the least that could be unstable times a half: 20 such steps
/// bring points three times nearer to true outlines; 60 begin to narrow canals of three voxels.
inline constexpr int plate_steps = 20;
inline constexpr double plate_step = 1.8;
/// How far a height may leave the distance that it began as, in voxels: a border's true place is that uncertain.
inline constexpr double plate_slack = 0.5;
/// Least height on either side of a border, in voxels: keeps crossings apart from voxels.
inline constexpr double plate_least = 0.02;
/// Largest label: floats hold all whole numbers up to 2^24, and none beyond is rounded to this one.
inline constexpr long largest_label = (1l << 24) - 1;
/// How far a volume's axes may be from square to each other (the dot product of two): headers round to six digits or
/// so.
inline constexpr double axes_out_of_square = 1e-4;
/// Turn of a volume's axes, degrees, that is rounding of the header and not worth a word.
inline constexpr double tilt_unspoken = 0.01;
/// How much larger the variance along the longest axis must be than along the next for the two to be told apart:
/// lengths that differ by a tenth. Of real teeth it is 3 and more, of a crown alone it may be less.
inline constexpr double long_axis = 1.2;
/// How unevenly DICOM slices may lie, as a part of their spacing: positions are written in thousandths or so.
inline constexpr double slice_unevenness = 0.02;
/// Most that the compressions of volume files shrink data (deflate: 1032 times); a header that asks for more than that
/// lies.
inline constexpr std::size_t compression_ratio = 1100;
/// Bins of a volume's histogram, and the share of voxels at either end that it does not stretch for: metal and the edge
/// of the scan.
inline constexpr std::size_t histogram_fineness = 1024;
inline constexpr double histogram_outliers = 1e-3;
/// Values of a label map that is told from a grey image: teeth have a few structures, jaws some sixty teeth and bones.
inline constexpr std::size_t few_labels = 64;
/// Dropped contours that are kept to be looked at.
inline constexpr std::size_t dropped_contours = 1'000'000;
/// Pairs of contours of two neighbouring slices that are looked at for canals that go on; noise has more.
inline constexpr std::size_t small_contour_pairs = 4'000'000;
/// Voxels up to which packed pixels are unpacked whatever they shrank to: a gigabyte of memory.
inline constexpr std::size_t plausible_voxels = 1ull << 28;
/// Beyond that number, how many bytes at most come from a packed one: scans shrink to a half or a fifth, label maps of
/// a tooth to a hundredth or two; only what is made to fill a machine's memory comes near deflate's utmost.
inline constexpr std::size_t suspicious_ratio = 500;
/// Bytes of a text header in front of a volume's pixels.
inline constexpr std::size_t header_bytes = 1u << 20;
/// Characters in a line of it: readers of old have buffers of 1,024 and more.
inline constexpr std::size_t header_line = 1000;
/// Elements of a DICOM file that are kept: twenty for each of limits::slices frames, and as many fragments of pixels.
inline constexpr std::size_t dicom_elements = 2'000'000;
/// Bytes of a value that is kept: the offsets of all frames as text.
inline constexpr std::size_t dicom_value = 1u << 20;
/// Bytes that a deflated DICOM file may unpack to, since they are held in memory: a slice has a few million.
inline constexpr std::size_t deflated_bytes = 1u << 30;
/// Files and folders that are looked at for DICOM images, and folders within each other: a whole CD has some ten
/// thousand.
inline constexpr std::size_t dicom_files = 200'000;
inline constexpr int dicom_folders = 16;
/// Decoding compressed DICOM pixels in a child process: seconds of processor time for each frame, seconds by the clock
/// without a finished frame (the machine may be busy), bytes of memory beyond what it began with and eight times the
/// frame, and bytes that are decoded in one go.
inline constexpr unsigned decoding_seconds = 20, decoding_seconds_by_clock = 300;
inline constexpr std::size_t decoding_bytes = 1u << 29, decoding_batch = 1u << 26;
/// Share of the slices' spacing that rounded positions may be off an even grid, where their last written digit explains
/// it. Less than a half, so that a missing slice is never taken for rounding.
inline constexpr double slice_rounding = 0.25;
/// The same where the spacing is given by hand.
inline constexpr double slice_rounding_by_hand = 0.45;
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

// --- between two slices ------------------------------------------------------------------------------------------
namespace odontoscope::limits {
/// Grid points across the narrowest contour or wall, and along the slab's larger side at least: the traced line is then
/// off by less than a hundredth of a canal's radius and a thousandth of the slice.
inline constexpr double blend_points_across = 5, blend_columns = 120;
/// Grid points along the larger side of a shape that is moved, in its own frame: it is sampled once more on the way to
/// the slice.
inline constexpr double blend_columns_of_moved = 48;
/// Grid points that a shape's window keeps free around it.
inline constexpr double blend_margin_steps = 4;
/// Part of the smaller shape's area that must lie in the other for two linked shapes to be blended in place; and the
/// part below which they are fully moved onto each other. A circle that shifts by 0.4 radii loses a quarter.
inline constexpr double blend_good_overlap = 0.75, blend_poor_overlap = 0.45;
/// How much more of it must overlap for a motion, or a change of size, to be believed.
inline constexpr double blend_better_overlap = 0.1;
/// Grid points along the larger side of two shapes whose overlap is counted, at most.
inline constexpr double overlap_columns = 200;
/// A contour continues in one of a slice beyond the slab if it is at most this many times as large or small, and at
/// most this many times the root of its area away.
inline constexpr double partner_area_ratio = 4, partner_distance = 2.5;
/// A neighbouring slab that is thinner than this part of the slab counts as this thick when slopes are weighed.
inline constexpr double blend_least_neighbour = 0.5;
/// Binary digits of coordinates below the size of the slab (2^-30 mm for a tooth of 10 mm), and below their distance
/// from the origin, so that sums of a few are still exact.
inline constexpr int blend_digits_of_size = 34, blend_digits_of_place = 50;
/// Grains of the coordinates in a step of the grid: contours keep a 64th of the step off its points, many grains.
inline constexpr double blend_grains_in_step = 1024;
/// Times that the tolerance of thinning may be doubled for a virtual slice to have no more points than the given ones.
inline constexpr int blend_thinning_rounds = 2;
/// A slice beyond the slab has a say in a shape if it shares this part of what it and its neighbour in the slab cover.
inline constexpr double blend_alike = 0.5;
/// How many times the lesser of the two curvatures that the slices beyond the slab tell of is believed: where one comes
/// from another shape (a furcation, a roof that closes) it is by far the larger.
inline constexpr double blend_bend = 2;
/// What of it is believed in any case, over the change within the slab.
inline constexpr double blend_bend_of_change = 0.8;
/// The power of a shape's inner radius that goes down evenly towards its tip: 1 for a cone, 2 for a paraboloid; cusps,
/// horns and the ends of roots are in between.
inline constexpr double blend_tip = 1.5;
/// Pieces, handles and bubbles by which a slab may be off what its links imply for more slices still to be tried: more
/// is noise, and stays so.
inline constexpr long mendable = 4;
/// And the most contours, and the least points, that a slab's two slices have together for that.
inline constexpr std::size_t few_contours = 16, fine_outlines = 80;
/// Where a shape ends at the earliest, over the slab's height.
inline constexpr double blend_least_end = 0.05;
}  // namespace odontoscope::limits
