#pragma once
// glTF 2.0, binary (Khronos Group; ISO/IEC 12113:2022): for viewers, web pages and engines.
//
// Metres and single precision. glTF's up is +y and ours, along the tooth, is +z: the coordinates stay as they are, and
// the root node turns them. Under it one node for each structure's external surfaces ("enamel external"), and one for
// its cavities ("tooth cavity"), each with a mesh of the same name, a material, and extras {structure, kind, shells,
// volume_mm3}. Triangles keep their winding, so that a cavity's wall faces into the cavity; materials are single-sided.
// Vertices are doubled where the surface has a crease, since a vertex has one normal; points that are distinct in the
// reconstruction stay distinct in single precision, so that joining vertices of equal position gives the surface back.
// asset.extras is the certificate. No extension is used unless the file is to be compressed (see compress_glb.h) or to
// have variants.
//
// A camera path becomes a node with a perspective camera, and an animation of its place and turn (LINEAR), all of its
// name. Which of several animations is played, and whether through its camera, is the viewer's choice.

#include <string>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/formats/camera_path.h"
#include "recon/formats/written_model.h"

namespace odontoscope {

/// A place with a name, for viewers that put a label there: a node without a mesh under the root, of this name, with
/// extras {hotspot: true}.
struct GlbHotspot {
  std::string name;
  Point3 at;  // mm
};

struct GlbOptions {
  /// Two triangles that meet at a sharper angle than this (degrees between their normals) are shaded apart.
  double crease_angle_deg = 60;
  /// Ways through the model that a viewer can play; without any the file has neither camera nor animation.
  std::vector<CameraPath> paths = {};
  /// Without loss, but readable by those only who know the extension EXT_meshopt_compression.
  bool compressed = false;
  /// Enamel, dentine and a tooth as a whole are blended (alphaMode BLEND), so that the pulp, or a cavity's far wall, is
  /// seen through them.
  bool see_through = false;
  /// Looks to choose from, by the extension KHR_materials_variants: "natural", "see-through", and "plaster", which is
  /// white all over. Readers that do not know it show what the materials are without it.
  bool variants = false;
  std::vector<GlbHotspot> hotspots = {};
};

/// The same reconstruction gives the same bytes: times and thread counts are left out. UsageError if the model is too
/// large for the format (limits::glb_bytes).
std::string glb_bytes(const WrittenModel& model, const GlbOptions& options = {});

/// The same as one text, its buffer embedded in base64 (.gltf).
std::string gltf_text(const WrittenModel& model, const GlbOptions& options = {});

}  // namespace odontoscope
