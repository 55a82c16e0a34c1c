#include "recon/output/write_vrml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "recon/core/portable_math.h"
#include "recon/formats/shell_groups.h"
#include "recon/formats/text_values.h"

namespace odontoscope {
namespace {

constexpr double crease_angle = 1.0472;     // 60 degrees, as in GLB
constexpr double quarter_turn = 1.5707963;  // +z up to +y up
constexpr double vrml_scale = 1e-3;

/// Where to look from, metres, after the turn: at the middle of the model along -z.
struct View {
  double x = 0, y = 0, z = 0;
  double middle_z = 0;
  double eye = 0;  // the size of whoever looks: no nearer than half of it is drawn
};

View view_of(const WrittenModel& model) {
  double low[3], high[3];
  std::fill_n(low, 3, std::numeric_limits<double>::max());
  std::fill_n(high, 3, std::numeric_limits<double>::lowest());
  for (const WrittenSurface& solid : model.solids) {
    for (const Point3& p : solid.surface.points) {
      const double turned[3] = {p.x, p.z, -p.y};
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], turned[axis] * vrml_scale);
        high[axis] = std::max(high[axis], turned[axis] * vrml_scale);
      }
    }
  }
  if (!(low[0] <= high[0])) return {};
  const double size = portable::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  constexpr double distance = 1.5,
                   eye_share = 1.0 / 200;  // of the size: the usual field of view of 45 degrees holds it
  return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2 + distance * size,
          (low[2] + high[2]) / 2, eye_share * size};
}

/// A group's own points, in order of first use, and its triangles in their numbers.
struct IndexedPart {
  std::vector<PointIndex> points;
  std::vector<Triangle> triangles;
};

IndexedPart part_of(const SurfaceMesh& mesh, const ShellGroup& group) {
  constexpr PointIndex unused = std::numeric_limits<PointIndex>::max();
  std::vector<PointIndex> number(mesh.points.size(), unused);
  IndexedPart part;
  for (const std::uint32_t t : group.triangles) {
    Triangle renumbered{};
    for (std::size_t k = 0; k < 3; ++k) {
      PointIndex& own = number[mesh.triangles[t][k]];
      if (own == unused) {
        own = static_cast<PointIndex>(part.points.size());
        part.points.push_back(mesh.triangles[t][k]);
      }
      renumbered[k] = own;
    }
    part.triangles.push_back(renumbered);
  }
  return part;
}

void append_points(std::string& text, const SurfaceMesh& mesh, const IndexedPart& part) {
  for (const PointIndex v : part.points) {
    const Point3& p = mesh.points[v];
    append_point(text, p);
    text += ",\n";
  }
}

void append_triangles(std::string& text, const IndexedPart& part) {
  for (const auto& [a, b, c] : part.triangles) fmt::format_to(std::back_inserter(text), "{} {} {} -1\n", a, b, c);
}

/// These formats' colours are those of a screen; ours are linear.
std::string colour_of(const ShellGroup& group) {
  const Paint& paint = paint_for(group.structure, group.kind);
  return fmt::format("{:.3f} {:.3f} {:.3f}", screen_value(paint.colour[0]), screen_value(paint.colour[1]),
                     screen_value(paint.colour[2]));
}

/// A name within quotes.
std::string vrml_quoted(const std::string& name) {
  std::string escaped;
  for (const char c : name) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return '"' + escaped + '"';
}

void append_vrml_shape(std::string& text, const WrittenSurface& solid, const ShellGroup& group,
                       Identifiers& identifiers) {
  const IndexedPart part = part_of(solid.surface, group);
  text += fmt::format(
      "WorldInfo {{ title {} }}\nDEF {} Shape {{\nappearance Appearance {{ material Material {{ diffuseColor {} }} }}\n"
      "geometry IndexedFaceSet {{\nsolid TRUE\nccw TRUE\nconvex TRUE\ncreaseAngle {}\n"
      "coord Coordinate {{ point [\n",
      vrml_quoted(group.name), identifiers.unique(group.name), colour_of(group), crease_angle);
  append_points(text, solid.surface, part);
  text += "] }\ncoordIndex [\n";
  append_triangles(text, part);
  text += "]\n}\n}\n";
}

void append_x3d_shape(std::string& text, const WrittenSurface& solid, const ShellGroup& group,
                      Identifiers& identifiers) {
  const IndexedPart part = part_of(solid.surface, group);
  text += fmt::format(
      "<Shape DEF=\"{}\">\n<MetadataString name=\"structure\" value=\"&quot;{}&quot;\"/>\n"
      "<Appearance><Material diffuseColor=\"{}\"/></Appearance>\n"
      "<IndexedFaceSet solid=\"true\" ccw=\"true\" convex=\"true\" creaseAngle=\"{}\" coordIndex=\"\n",
      identifiers.unique(group.name),
      xml_escaped(vrml_quoted(group.name).substr(1, vrml_quoted(group.name).size() - 2)), colour_of(group),
      crease_angle);
  append_triangles(text, part);
  text += "\">\n<Coordinate point=\"\n";
  append_points(text, solid.surface, part);
  text += "\"/>\n</IndexedFaceSet>\n</Shape>\n";
}

}  // namespace

std::string vrml_text(const WrittenModel& model) {
  const View view = view_of(model);
  std::string text = fmt::format(
      "#VRML V2.0 utf8\n# made by odontoscope\n"
      "WorldInfo {{ title \"odontoscope model\" info [ \"{}\", \"coordinates in millimetres, +z along the tooth\" ] "
      "}}\n"
      "NavigationInfo {{ type [ \"EXAMINE\", \"ANY\" ] avatarSize [ {:.6f}, {:.6f}, {:.6f} ] headlight TRUE }}\n"
      "Viewpoint {{ position {:.6f} {:.6f} {:.6f} description \"the whole tooth\" }}\n"
      "Transform {{\nscale {} {} {}\nrotation 1 0 0 -{}\nchildren [\n",
      certificate_in_words(model), view.eye, view.eye, view.eye, view.x, view.y, view.z, vrml_scale, vrml_scale,
      vrml_scale, quarter_turn);
  Identifiers identifiers;
  for (const WrittenSurface& solid : model.solids) {
    for (const ShellGroup& group : shell_groups(solid)) append_vrml_shape(text, solid, group, identifiers);
  }
  return text + "]\n}\n";
}

std::string x3d_text(const WrittenModel& model) {
  const View view = view_of(model);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<X3D profile=\"Immersive\" version=\"3.3\">\n<head>\n<meta name=\"generator\" content=\"odontoscope\"/>\n"
      "<meta name=\"certificate\" content=\"{}\"/>\n<meta name=\"coordinates\" content=\"millimetres, +z along the "
      "tooth\"/>\n"
      "</head>\n<Scene>\n<NavigationInfo type='\"EXAMINE\" \"ANY\"' avatarSize=\"{:.6f} {:.6f} {:.6f}\" "
      "headlight=\"true\"/>\n"
      "<Viewpoint position=\"{:.6f} {:.6f} {:.6f}\" centerOfRotation=\"{:.6f} {:.6f} {:.6f}\" description=\"the whole "
      "tooth\"/>\n"
      "<Transform scale=\"{} {} {}\" rotation=\"1 0 0 -{}\">\n",
      certificate_in_words(model), view.eye, view.eye, view.eye, view.x, view.y, view.z, view.x, view.y, view.middle_z,
      vrml_scale, vrml_scale, vrml_scale, quarter_turn);
  Identifiers identifiers;
  for (const WrittenSurface& solid : model.solids) {
    for (const ShellGroup& group : shell_groups(solid)) append_x3d_shape(text, solid, group, identifiers);
  }
  return text + "</Transform>\n</Scene>\n</X3D>\n";
}

}  // namespace odontoscope
