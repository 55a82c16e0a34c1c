#pragma once
// Numbers and names as text formats want them. For writers.

#include <set>
#include <string>
#include <string_view>

#include "recon/core/geometry.h"

namespace odontoscope {

/// The shortest decimal number that gives the same double again; -0 becomes 0.
void append_number(std::string& text, double value);
/// The same in at most `most` characters (15 or more), then with as many digits as fit.
void append_number(std::string& text, double value, std::size_t most);

/// "x y z".
void append_point(std::string& text, const Point3& p);

/// Text within an XML element or attribute.
std::string xml_escaped(std::string_view text);

/// Names for formats that allow letters, digits and "_" only: each different from those before, in any case of letters.
class Identifiers {
 public:
  /// "tooth+pulp cavity" becomes "tooth_pulp_cavity"; one that begins with a digit gets an "S" in front.
  std::string unique(std::string_view name);

 private:
  std::set<std::string> taken_;  // in lower case
};

}  // namespace odontoscope
