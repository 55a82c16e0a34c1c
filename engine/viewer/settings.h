#pragma once
// What the viewer remembers from one run to the next.
//
// A small JSON file, $XDG_CONFIG_HOME/odontoscope/viewer.json (~/.config where that is not set). Deleting it brings
// back the defaults; whatever it holds, the viewer starts: what makes no sense is left at its default and said once.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/gpu/framebuffer.h"
#include "engine/scene/scene.h"

namespace odontoscope {

enum class Backdrop { dark, light, white };

struct PictureSettings {
  int width = 2400, height = 1800;
  bool as_seen = true;  // the height follows the shape of the view
  int side = 3;         // samples a pixel along one axis
  bool transparent = false;
  friend bool operator==(const PictureSettings&, const PictureSettings&) = default;
};

/// Flying makes some people dizzy: what helps them.
struct Comfort {
  double field_of_view_deg = 75;
  double speed_limit = 24;      // times the usual speed
  bool vignette = false;        // a dark rim while the picture turns
  bool reduced_motion = false;  // no dives, slower turns
  bool wall_depth = true;       // canals' walls carry their depth: Scene::wall_depth
  bool wall_thickness = false;  // or in its place their thickness: Scene::wall_thickness
  friend bool operator==(const Comfort&, const Comfort&) = default;
};

/// What a person gave a structure of that name, in whatever model.
struct RememberedLook {
  std::string structure;
  Colour colour;
  float opacity = 1;
  friend bool operator==(const RememberedLook&, const RememberedLook&) = default;
};
inline constexpr std::size_t most_remembered_looks = 64, most_structure_bytes = 200;
inline constexpr std::size_t most_recent_files = 8, most_path_bytes = 4096;

struct Settings {
  PixelSize window{1280, 800};
  bool panel = true;
  bool names = true;             // beside the tooth, from outside
  bool hints = true;             // for the first run: until they are followed or closed
  bool desktop_dialogs = true;   // files are chosen in the desktop's dialog, where there is one
  std::string save_folder = {};  // where pictures, scenes and lessons go; empty: the current one
  std::string language = {};     // a tag; empty: as the environment says
  float text_scale = 1;          // on top of the screen's own
  BackFaces back_faces = BackFaces::cull;
  Camera::Projection projection = Camera::Projection::perspective;
  Backdrop backdrop = Backdrop::dark;
  PictureSettings picture = {};
  Comfort comfort = {};
  std::vector<RememberedLook> looks = {};  // the latest last; the oldest are forgotten
  std::vector<std::string> recent = {};    // files that were opened, the latest first
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// By its whole path, before all others.
void remember_file(Settings& settings, const std::string& file);

Background background_of(Backdrop backdrop);

/// Colour and opacity as they are now.
void remember(Settings& settings, const Look& look);
/// No longer for this structure.
void forget(Settings& settings, const std::string& structure);
/// Colours and opacities that are remembered for structures of `scene`.
void apply_remembered(const Settings& settings, Scene& scene);

struct ReadSettings {
  Settings settings;
  std::string complaint;  // empty if all was well or there was no file
};

/// Numbers beyond what settings_from_json takes are moved to the nearest that it takes: what is written can always be
/// read.
std::string to_json(const Settings& settings);
/// Never throws for what the text holds.
ReadSettings settings_from_json(const std::string& text);

/// Empty if the environment names no home.
std::filesystem::path settings_file();
ReadSettings read_settings(const std::filesystem::path& file);
/// Whole or not at all, the folder made if need be. Throws FileError.
void write_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace odontoscope
