#include "recon/formats/write_obj.h"

#include <fmt/format.h>

#include <iterator>

#include "recon/formats/shell_groups.h"
#include "recon/formats/text_values.h"

namespace odontoscope {

std::string obj_text(const WrittenModel& model) {
  std::string text =
      fmt::format("# made by odontoscope; millimetres, +z along the tooth\n# {}\n", certificate_in_words(model));
  Identifiers identifiers;  // many readers end a name at the first blank
  std::size_t first = 1;    // vertices are counted from 1 through the whole file
  for (const WrittenSurface& solid : model.solids) {
    for (const Point3& p : solid.surface.points) {
      text += 'v';
      for (const double coordinate : {p.x, p.y, p.z}) {
        text += ' ';
        append_number(text, coordinate);
      }
      text += '\n';
    }
    for (const ShellGroup& group : shell_groups(solid)) {
      text += fmt::format("# {}\no {}\n", group.name, identifiers.unique(group.name));
      for (const std::uint32_t t : group.triangles) {
        const auto& [a, b, c] = solid.surface.triangles[t];
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", first + a, first + b, first + c);
      }
    }
    first += solid.surface.points.size();
  }
  return text;
}

}  // namespace odontoscope
