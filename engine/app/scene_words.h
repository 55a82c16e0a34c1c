#pragma once
// How a scene is told in words: those of the command line, and of the Python package.

#include <optional>
#include <string>
#include <vector>

#include "engine/gpu/framebuffer.h"
#include "engine/scene/overlay.h"
#include "engine/scene/scene.h"
#include "engine/scene/value_grid.h"

namespace odontoscope::app {

/// As typed; not yet understood. Whoever takes them keeps `zoom` from 0.01 to 100 and `occlusion` from 0 to 4.
struct SceneWords {
  std::string scene_file, camera_file, view;
  bool parallel = false;
  double zoom = 1;
  std::vector<std::string> hide;     // "S"
  std::vector<std::string> opacity;  // "S=0.3"
  std::vector<std::string> colour;   // "S=#rrggbb"
  std::string section, cap, back_faces, background;
  std::vector<std::string> overlays;  // "contours", "edges", "tetrahedra", "tetrahedra=N"
  std::optional<double> occlusion;
  bool wire = false, wall_depth = false, wall_thickness = false;
};

/// Throws what scene_from would throw whatever the model is: to be called before any long work.
void refuse_senseless(const SceneWords& words);

/// Likewise for names of structures, once the contours are read and before a model is made of them: `--hide`,
/// `--opacity` and `--colour` name what is in the stack, or a cavity in it.
void refuse_unknown_structures(const SceneWords& words, const ContourStack& stack);

/// The model's usual scene, then what the scene file says, then the words. Throws UsageError for words that make no
/// sense (a structure that the model has not, a view that there is none), FileError and InputError for the files.
/// UsageError, too, for overlays that the input cannot have, and for a cap of CT values without `values` (null: the
/// input is no volume).
Scene scene_from(const SceneWords& words, const odontoscope::Model& model, const OverlaySource& overlays,
                 const ValueGrid* values, PixelSize size);

/// What is told ("1200x900", samples), else what the scene file (may be empty) keeps, else `usual`. Throws as size_from
/// and read_scene do.
PictureFormat picture_format(const std::string& size, std::optional<int> samples, const std::string& scene_file,
                             PixelSize usual);

/// Samples a pixel along one axis.
int side_of(const PictureFormat& format);

/// "1200x900"; UsageError unless both are from 1 to `most_picture_side`.
PixelSize size_from(const std::string& text);

/// "+y", "-x@2.5", "buccal", "1,1,0@3": what is cut away, and where the plane lies (mm along that axis; the model's
/// middle if not told). Public for tests.
Section section_from(const std::string& text, const odontoscope::Model& model);

}  // namespace odontoscope::app
