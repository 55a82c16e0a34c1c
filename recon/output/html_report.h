#pragma once
// What the writers of web pages have in common: the pages of assets/reports, and text in them.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace odontoscope {

/// Text as text, in an element or in a quoted attribute, whatever is in it.
std::string escaped_html(std::string_view text);

/// "#2a7f62", of 0x2a7f62.
std::string hex_colour(unsigned rgb);

/// What stands at each {{place}} of a page; as it is, so escape what is text.
using PagePlaces = std::vector<std::pair<std::string_view, std::string>>;

/// The page of assets/reports of that name, with `places` and, where it says {{style}}, with the style sheet that all
/// reports share. Throws InternalError for a page that is not there, and for places that the page lacks or leaves open.
std::string html_report(std::string_view name, const PagePlaces& places);

/// A style sheet of assets/reports as it is there.
std::string_view report_file(std::string_view name);

}  // namespace odontoscope
