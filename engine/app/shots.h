#pragma once
// Files that become pictures before they are compared: GLB files and scenes are drawn by this program, pages by a
// browser.

#include <map>
#include <memory>
#include <string>

#include "engine/app/command.h"
#include "engine/app/page_shot.h"
#include "engine/picture/compare_folders.h"

namespace odontoscope::app {

struct ShotWords {
  std::string model;       // what scenes without a GLB of their name show
  std::string browser;     // empty: see browser_program
  double timeout_s = 120;  // for each
};

/// What one picture is drawn from. A scene and a GLB of one name are one picture: the GLB from where the scene looks.
struct ShotSource {
  std::string page, glb, scene;  // files; at least one of page, glb, scene
};

class Shots {
 public:
  Shots(const ShotWords& words, Session& session) : words_(words), session_(session) {}

  /// All of a folder and those below: *.html, *.glb, and *.json that hold a scene; but the files that are named
  /// `besides`. Throws UsageError where two of them, or one and a PNG, are one picture, and for scenes without anything
  /// to show; FileError.
  void find(const std::string& folder, const std::vector<std::string>& besides);
  /// A single file; false if it is none of these.
  bool take(const std::string& file);

  PicturesToDraw pictures();

 private:
  void add(const std::string& name, const std::string& file);
  void check() const;
  Image draw(const std::string& name, int width, int height);
  Image draw_model(const ShotSource& source, int width, int height);

  ShotWords words_;
  Session& session_;
  std::map<std::string, ShotSource> sources_;  // by the picture's name
  std::unique_ptr<PageShots> browser_;         // started when the first page wants it
};

}  // namespace odontoscope::app
