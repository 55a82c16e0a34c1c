#pragma once
// The links format of docs/formats.md, from memory and back.

#include <string>
#include <string_view>
#include <vector>

#include "recon/input/links.h"

namespace odontoscope {

/// As `read_links` (links.h), from memory; `name` stands for the file in messages.
std::vector<Link> parse_links(std::string_view bytes, std::string name);

/// A link as a report tells it.
struct ReportedLink {
  Link link;
  /// Why it was made: a short plain name such as "medial".
  std::string criterion;
};

/// The text of a links file, a link a line, that `read_links` reads back. Same links, same bytes.
std::string links_to_json(const std::vector<ReportedLink>& links);

}  // namespace odontoscope
