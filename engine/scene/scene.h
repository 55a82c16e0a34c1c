#pragma once
// What is shown and how: a plain value that can be compared, saved as JSON and drawn again.
//
// The geometry is not part of it (see model.h); looks are matched to the model's parts by structure name.

#include <optional>
#include <string>
#include <vector>

#include "assets/theme.h"
#include "engine/scene/camera.h"
#include "engine/scene/colour.h"
#include "engine/scene/data_colours.h"
#include "engine/scene/model.h"
#include "engine/scene/volume_look.h"
#include "recon/core/named.h"

namespace odontoscope {

struct Look {
  std::string structure;
  Colour colour;
  float opacity = 1;  // 0 to 1; less than 1 is translucent
  bool visible = true;
  /// Turn the surface inside out: a cavity is then seen from outside as the body that would fill it. Still by winding.
  bool as_body = false;
  friend bool operator==(const Look&, const Look&) = default;
};

/// Everything on the side that `normal` points to is cut away; closed solids are capped in their own colour.
struct Section {
  glm::dvec3 point_mm{0};
  glm::dvec3 normal{0, 1, 0};  // of any length but 0
  friend bool operator==(const Section&, const Section&) = default;
};

/// The grey values that are shown black and white; what lies between is grey in proportion.
struct ValueWindow {
  double low = 0, high = 1;
  /// Both finite and of a size that graphics processors reckon with, `low` clearly below `high`.
  bool sensible() const;
  friend bool operator==(const ValueWindow&, const ValueWindow&) = default;
};

/// What a section's cap shows: the material, that is the structure's colour with a grain, lit; the same without the
/// grain, for measuring colours; or the values of the volume that the model came from (see value_grid.h), which no
/// light changes and only a volume has.
struct CapLook {
  enum class Shows { material, plain, ct };
  Shows shows = Shows::material;
  std::optional<ValueWindow> window;  // none: the volume's usual one
  friend bool operator==(const CapLook&, const CapLook&) = default;
};

inline constexpr NameTable<CapLook::Shows, 3> cap_contents{
    {{"material", CapLook::Shows::material}, {"plain", CapLook::Shows::plain}, {"ct", CapLook::Shows::ct}}};

/// What happens to triangles seen from behind, that is clockwise: left out as game engines and web viewers do, drawn
/// like any other, or drawn in an alarming colour.
enum class BackFaces { cull, show, tint };
inline constexpr NameTable<BackFaces, 3> back_face_modes{
    {{"cull", BackFaces::cull}, {"show", BackFaces::show}, {"tint", BackFaces::tint}}};

struct Background {
  enum class Kind { plain, gradient, transparent };
  Kind kind = Kind::gradient;
  Colour top = colour_of(assets::theme::interface::light::sky_top);  // `plain` has only this one
  Colour bottom = colour_of(assets::theme::interface::light::sky_bottom);
  friend bool operator==(const Background&, const Background&) = default;
};

inline constexpr NameTable<Background::Kind, 3> background_kinds{{{"plain", Background::Kind::plain},
                                                                  {"gradient", Background::Kind::gradient},
                                                                  {"transparent", Background::Kind::transparent}}};

/// Screen-space ambient occlusion: how much darker it is where little sky is seen.
struct Occlusion {
  bool on = true;
  float strength = 1.0f;  // 0 none, 1 natural, more for emphasis
  /// How far away things still darken, as part of the model's radius: about the width of a fissure.
  float reach = 0.12f;
  friend bool operator==(const Occlusion&, const Occlusion&) = default;
};

/// A lamp that the eye carries along, instead of the studio's lights: for places that no light falls into.
struct Headlight {
  double reach_mm = 1;  // at this distance half of it is left
  friend bool operator==(const Headlight&, const Headlight&) = default;
};

/// What is drawn over the surfaces, if the overlay's source knows it (see overlay.h).
struct OverlayChoice {
  bool contours = false;  // of the slices; with a slab only of the two that bound it
  bool edges = false;     // boundary, non-manifold and misoriented ones
  /// The tetrahedra between slice `slab` and the next, counted from 0, each shrunk towards its centre by `shrink`.
  std::optional<std::size_t> slab;
  float shrink = 0.8f;  // 1 leaves them as they are
  friend bool operator==(const OverlayChoice&, const OverlayChoice&) = default;
};

/// How large a picture of a scene is, in pixels, and how many samples each of them has: 1, 4, 9 or 16.
struct PictureFormat {
  int width = 1200, height = 900, samples = 4;
  friend bool operator==(const PictureFormat&, const PictureFormat&) = default;
};

struct Scene {
  Camera camera;
  std::vector<Look> looks;
  std::optional<Section> section;
  CapLook cap;
  VolumeLook volume;  // of a model that has values, see value_grid.h
  BackFaces back_faces = BackFaces::cull;
  bool wire = false;
  OverlayChoice overlays;
  Background background;
  Occlusion occlusion;
  std::optional<Headlight> headlight;
  /// Canals' walls tell their depth below the orifice: by colour, a ring every Model::depth_step_mm and a bolder one
  /// every five of them (ModelPart::depths_mm).
  bool wall_depth = false;
  /// In place of depth, how thick walls are to the outside: thin ones blue, a line every Model::thickness_step_mm and a
  /// bolder one every five of them (ModelPart::thicknesses_mm); so do bodies that fill a cavity.
  bool wall_thickness = false;
  /// Surfaces are coloured by how they lie to the data (ModelPart::deviations); none: in their own colours.
  std::optional<DataColours> data_colours;
  /// Of the picture that the scene was kept with; none: whoever draws it says.
  std::optional<PictureFormat> picture;

  Look* look_of(std::string_view structure);
  const Look* look_of(std::string_view structure) const;
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// What one structure hides, nothing shows: all is opaque, and back faces are left out.
void make_opaque(Scene& scene);

/// A good first look at the model: every structure in its usual colour, from three quarters. What hides another
/// structure is translucent: enamel over dentine, dentine over pulp, and anything whose box holds that of another
/// structure. A cavity that nothing fills is shown as the body that would.
Scene usual_scene(const Model& model, double aspect);

/// How clear structures become around a volume, at most.
inline constexpr float around_volume = 0.15f;

/// Shows surfaces, volume or both of them: then structures become clear, and greys along whole rays, which have no
/// depth, are no way to cast any more.
void show_as(VolumeLook::Shows shows, Scene& scene);

}  // namespace odontoscope
