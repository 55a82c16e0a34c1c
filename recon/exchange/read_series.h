#pragma once
// Series of the program Reconstruct (J. C. Fiala, "Reconstruct: a free editor for serial section microscopy", Journal
// of Microscopy 218(1), 2005): an XML file NAME.ser, and beside it one for each section, NAME.1, NAME.2, ...; other
// endings are no sections.
//
// Each contour stands within a transform, whose polynomials in x and y lead from the series' plane to the contour's
// own; they are inverted here, so that contours come out aligned. A section's height is the sum of the thicknesses
// below it, and half its own if the series says zMidSection. Contours of a transform with an image are the image's
// frame and are left out, as are contours that are not closed. Names are as they stand there. Units: microns, nm, mm,
// cm, m.

#include <string>
#include <string_view>
#include <vector>

#include "recon/exchange/contour_file.h"

namespace odontoscope {

struct SeriesHeader {
  double millimetres = 1;        // a unit of the series
  double default_thickness = 0;  // in such units, for sections that are missing
  bool middle = false;           // zMidSection
};

struct SeriesSection {
  long index = 0;
  double thickness = 0;  // in units of the series
  std::vector<Contour> contours;
  std::size_t open = 0, frames = 0;  // contours left out
};

bool looks_like_series(std::string_view bytes);

/// `bytes` are those of the .ser; sections are read from its folder. Throws FileError, or InputError:
///   unparsable       no XML, or a number that is none
///   missing-key      a section or contour lacks an attribute
///   wrong-type       the root is no Series or Section
///   wrong-unit, not-finite, too-large, bad-name, and the counts as in stack_json.h
///   wrong-section    a file is not of the section that its ending says
///   bad-transform    a transform that has no inverse there
///   no-sections      no file of a section is there
FileContours read_series(std::string_view bytes, const std::string& file);

/// Its parts, from memory.
SeriesHeader parse_series_header(std::string_view bytes, const std::string& file);
SeriesSection parse_series_section(std::string_view bytes, const std::string& file);

}  // namespace odontoscope
