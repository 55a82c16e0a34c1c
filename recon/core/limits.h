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
/// Points in a stack: 32-bit vertex numbers stay safe with Steiner points and lifted points added.
inline constexpr std::size_t points = 100'000'000;
/// Structures (names) in a stack: labels are 16 bit.
inline constexpr std::size_t structures = 1'000;
/// Characters in a name.
inline constexpr std::size_t name_length = 200;
/// Bytes of a text or mesh file that is read whole.
inline constexpr std::size_t file_bytes = 4ull << 30;
/// Voxels of a volume: 2 GiB of 16 bit.
inline constexpr std::size_t voxels = 1ull << 30;

}  // namespace odontoscope::limits
