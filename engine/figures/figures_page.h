#pragma once
// The figures as a page.

#include <string>
#include <vector>

#include "engine/figures/figure.h"

namespace odontoscope::figures {

/// A page that needs nothing but the pictures beside it (see picture_name), for phones and wide screens. `about`: what
/// they were made from, a sentence.
std::string index_page(const std::vector<Figure>& figures, const std::string& about);

}  // namespace odontoscope::figures
