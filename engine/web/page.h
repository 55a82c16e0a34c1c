#pragma once
// A model as a web page in one file: it opens from disk in a browser, asks the network for nothing, and needs no other
// program.
//
// The page's own text is web/, bundled when the program is built (see embedded_page). Here the model goes into it: GLB
// files as write_glb makes them, compressed with gzip, and what is said of them as JSON. No text of the input becomes
// markup or code: it is escaped here, put into the page as text alone by the page's script, and a content security
// policy allows no script but that one.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recon/core/geometry.h"
#include "recon/formats/camera_path.h"

namespace odontoscope {

/// Is the surface what it should be? In words for a person; see Certificate in engine/ui.
struct WebCertificate {
  struct Finding {
    std::string mark = "good";  // "good", "look" or "bad"
    std::string words;
    std::optional<Point3> at_mm = {};  // where to look
  };
  std::string verdict;  // "certified", "amber" (certified, but some places want a look), "sound" or "wanting"
  std::string headline;
  std::vector<Finding> findings;
};

/// One way to make the model's surfaces; a page with two has a switch.
struct WebModel {
  std::string name;   // "DT"
  std::string words;  // what it is, a sentence
  std::string glb;    // bytes
  std::size_t triangles = 0;
  WebCertificate certificate;
};

/// How a structure looks at first. `structure` is a node's `extras.structure` in the GLB, with " cavity" behind it for
/// its cavities.
struct WebLook {
  std::string structure;
  std::string colour;  // "#f2e9d8"
  float opacity = 1;
  bool as_body = false;                    // see Look in engine/scene
  int depth = 0;                           // what lies deeper is drawn first where it is seen through others
  std::optional<double> attenuation = {};  // of X-rays, 1/mm; none: no tissue is known by this name
};

/// The value at which the surface of a structure was taken.
struct WebIso {
  std::string structure;
  double value = 0;
};

/// Grey values of the volume that the model came from. Value (i, j, k) belongs to the place first_mm + (i, j, k) *
/// step_mm.
struct WebVolume {
  std::array<std::size_t, 3> size{};
  Point3 first_mm, step_mm{1, 1, 1};
  double low = 0, high = 255;      // what the bytes 0 and 255 stand for; those between follow in proportion
  std::string bytes;               // x runs fastest, then y, then z
  double air = 0, dentine = 1;     // what values mean
  double dentine_attenuation = 0;  // of X-rays, 1/mm
  std::vector<WebIso> isos;        // at which surfaces were taken
  std::vector<double> bars;        // of a histogram from `low` to `high`, 0 to 1
  std::string look;                // JSON, as a scene file has it under "volume"
  std::vector<std::pair<std::string, std::string>>
      transfers;       // ready-made ones: a name, and JSON as the look's "transfer"
  bool alone = false;  // the model is but a box around it, and is never shown
};

/// A way through a canal, from the chamber to its end. Millimetres, in the model's coordinates.
struct WebTour {
  std::string name;
  std::vector<Point3> points;
  double length_mm = 0;                   // of the canal, as the anatomy tells it: CentreLine::length_to_wall
  std::optional<double> orifice_mm = {};  // along the points, where depth is counted from; none: nowhere
  std::vector<CameraKey> keys = {};       // of the camera that flies it, even in time; none: it is not flown
};

struct WebPage {
  std::string title;
  std::vector<WebModel> models;  // one or more
  std::vector<WebLook> looks;
  std::vector<WebTour> tours;
  std::string tooth = {};      // "lower left first molar: FDI 36, Universal 19"; empty: not known
  std::vector<WebTour> horns;  // of the pulp, from the chamber to their tips; only names and points count
  std::optional<WebVolume> volume = {};
  std::string lesson;            // a tour file (engine/navigate/notes.h) that the page opens with; empty: none
  bool lesson_built_in = false;  // its texts are among those of the languages
  std::string language = {};     // JSON: a language file (engine/language) of its own, or {"language":"de"} of a known
                                 // one; empty: the browser's
};

/// The page without a model. Empty if this program was built without it; `why` then says what was missing.
struct EmbeddedPage {
  std::string_view html;
  std::string_view why;
};
EmbeddedPage embedded_page();

/// The same input gives the same bytes. Precondition: `shell` is not empty. InternalError if it has not the places that
/// are filled.
std::string web_page(const WebPage& page, std::string_view shell);

/// How many bytes of the page hold the volume's values.
std::size_t packed_size(const WebVolume& volume);

}  // namespace odontoscope
