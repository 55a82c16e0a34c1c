// In place of the page that engine/web builds into the program: here JavaScript puts it into the file system, so that a
// module without pages stays small.
#include <fstream>
#include <iterator>
#include <string>

#include "engine/web/page.h"

namespace odontoscope {

EmbeddedPage embedded_page() {
  static const std::string html = [] {
    std::ifstream in("/odontoscope/page.html", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
  return {html, html.empty() ? "there is no file /odontoscope/page.html" : ""};
}

}  // namespace odontoscope
