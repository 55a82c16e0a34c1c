#pragma once
// Another program, as ffmpeg or a browser: where it is, and what it says.

#include <string>
#include <vector>

namespace odontoscope {

/// Of what a program said: that is most often what is wrong. Control characters become blanks.
std::string last_line(const std::string& text);

/// The first of these programs that PATH has, with its folder; empty: none.
std::string program_in_path(const std::vector<std::string>& names);

}  // namespace odontoscope
