#pragma once
// Limits of this room, each with its reason.

#include <cstddef>

namespace odontoscope::limits {

/// Rows of a list in a tooth's table: no tooth has half as many cusps, furrows, roots or canals.
inline constexpr std::size_t table_rows = 64;
/// The largest number in it, mm or a ratio, either way: beyond it stands for "nowhere".
inline constexpr double table_number = 1000;

}  // namespace odontoscope::limits
