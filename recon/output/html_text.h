#pragma once
// What the writers of web pages have in common.

#include <string>
#include <string_view>

namespace odontoscope {

/// Text as text, in an element or in a quoted attribute, whatever is in it.
std::string escaped_html(std::string_view text);

}  // namespace odontoscope
