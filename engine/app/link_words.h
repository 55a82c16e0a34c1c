#pragma once
// Links as a person types them on the command line: --link pulp:12:0-1.

#include <string>
#include <vector>

#include "recon/input/links.h"

namespace odontoscope::app {

/// As which option it was given.
enum class LinkOption { link, unlink };

/// "STRUCTURE:SLICE:LOWER-UPPER"; a structure's name may hold colons. UsageError if it
/// is not that.
Link link_from(const std::string& word, LinkOption option);

struct LinkWords {
  std::vector<std::string> connect, apart;
  bool any() const { return !connect.empty() || !apart.empty(); }
};

/// All of them, in the order connected, apart.
std::vector<Link> links_from(const LinkWords& words);

}  // namespace odontoscope::app
