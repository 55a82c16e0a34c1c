#pragma once
// The certificate's verdict, and its words. Everything that shows a certificate (terminal, report, viewer, page) takes
// it from here.

#include <string>
#include <vector>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope {

enum class Verdict {
  green,  // certified, every slab has the pieces, handles and bubbles that contours and links imply, and nothing else
          // needs a look
  amber,  // certified, but look at the places in Reconstruction::attention
  red,    // not certified
};

/// "green", "amber", "red".
const char* name(Verdict verdict);

/// Red unless the reconstruction is certified and every surface in it, as it now is (perhaps simplified), is a closed
/// oriented manifold.
Verdict verdict_of(const Reconstruction& reconstruction);

/// One line: "Green: ...", "Amber: certified, but look at 3 places".
std::string headline(const Reconstruction& reconstruction);

/// "pulp, slices 12 and 13 (z 3 to 3.25 mm), near (1.2, 3.4, 3.1): ..." with what is seen, the Euler characteristics
/// where they differ or the item is about them, and the remedy.
std::string in_words(const Attention& item);

/// The option that says a link on the command line, quoted for a shell where need be: "--link pulp:12:0-1", "--unlink
/// pulp:12:0-1".
std::string option_for(const Link& link);

/// "Changed between slices: 12 tetrahedra trimmed in 2 slabs (0.31 mm^3), ..."; empty if nothing was.
std::string in_words(const std::vector<SlabChange>& changes);

}  // namespace odontoscope
