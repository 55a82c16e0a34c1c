#pragma once
// Where one looks from. All lengths in the user's millimetres.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "engine/scene/model.h"
#include "recon/core/named.h"

namespace odontoscope {

struct Camera {
  enum class Projection { perspective, parallel };
  Projection projection = Projection::perspective;
  glm::dvec3 position{0, 60, 0};
  glm::dvec3 target{0};
  glm::dvec3 up{0, 0, 1};         // need not be at right angles to the line of sight, only not along it
  double field_of_view_deg = 24;  // from top to bottom; perspective only
  double height_mm = 25;          // seen from top to bottom; parallel only
  /// What lies nearer to the picture's plane is cut off: never more than this; 0 leaves it to the model's size. For an
  /// eye between walls; perspective only.
  double near_mm = 0;
  friend bool operator==(const Camera&, const Camera&) = default;
};

inline constexpr NameTable<Camera::Projection, 2> camera_projections{
    {{"perspective", Camera::Projection::perspective}, {"parallel", Camera::Projection::parallel}}};

/// Directions of a tooth in the model's coordinates, unit vectors. The default is the project's convention: roots at
/// low z, crown at high z; buccal (or labial) is +y, mesial +x.
struct AnatomicalFrame {
  glm::dvec3 occlusal{0, 0, 1};
  glm::dvec3 buccal{0, 1, 0};
  glm::dvec3 mesial{1, 0, 0};
};

enum class NamedView { three_quarter, buccal, lingual, mesial, distal, occlusal, apical };

inline constexpr NameTable<NamedView, 7> named_views{{{"three-quarter", NamedView::three_quarter},
                                                      {"buccal", NamedView::buccal},
                                                      {"lingual", NamedView::lingual},
                                                      {"mesial", NamedView::mesial},
                                                      {"distal", NamedView::distal},
                                                      {"occlusal", NamedView::occlusal},
                                                      {"apical", NamedView::apical}}};
inline const char* name(NamedView view) { return word_of(named_views, view); }
/// Throws UsageError with the list of names.
inline NamedView view_named(std::string_view name) { return value_named(named_views, name, "view"); }

/// Unit vectors: to where the eye stands, and what is upwards in the picture, at right angles to it or nearly.
struct ViewDirection {
  glm::dvec3 towards_eye, up;
};
ViewDirection direction_of(NamedView view, const AnatomicalFrame& frame = {});

/// Looks at the model from the named side, all of it in the picture whatever its turn, with a small margin.
/// `aspect` is width over height.
Camera fit(NamedView view, const Model& model, double aspect,
           Camera::Projection projection = Camera::Projection::perspective, const AnatomicalFrame& frame = {});

/// The model seen along the camera's own line of sight, all of it in the picture as above.
Camera fit(const Camera& camera, const Model& model, double aspect);

/// One eye: what it sees, for the model's coordinates in metres. A stereo pair is two of these.
struct View {
  glm::mat4 world_to_eye{1};  // eye looks along -z, y up
  glm::mat4 eye_to_clip{1};   // OpenGL clip space
};

/// Near and far are set as tight as the model allows. Precondition: position and target differ, up is not along the
/// line between.
View view_of(const Camera& camera, const Model& model, double aspect);

/// Throws InputError bad-camera unless a view can be made of it: finite, position and target apart, up not along
/// the line of sight, angle of view in (0, 170) degrees, height positive.
void validate(const Camera& camera, std::string_view file);

}  // namespace odontoscope
