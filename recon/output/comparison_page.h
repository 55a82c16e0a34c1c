#pragma once
// A comparison as a page that stands alone: style, charts and pictures are all within the one file.

#include <string>

#include "recon/compare/compare.h"

namespace odontoscope {

/// HTML 5, UTF-8. The table of comparison_rows, distances between the methods, charts of the triangles' smallest
/// angles, and the pictures of each method (ComparedMethod::pictures, PNG, embedded) with their captions, in one row a
/// picture number. Text from the input is escaped.
std::string comparison_page(const Comparison& comparison);

}  // namespace odontoscope
