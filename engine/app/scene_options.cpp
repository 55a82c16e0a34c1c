#include "engine/app/scene_options.h"

#include "engine/app/options.h"

namespace odontoscope::app {

void add_scene_options(CLI::App& parser, SceneWords& words) {
  constexpr const char* looking = "Looking";
  constexpr const char* showing = "Showing";
  CLI::Option* view = parser.add_option("--view", words.view,
                                        "three-quarter (default), buccal, lingual, mesial, distal, occlusal, apical");
  view->type_name("NAME")->group(looking);
  parser.add_option("--camera", words.camera_file, "The camera of a saved scene")
      ->type_name("FILE.json")
      ->group(looking)
      ->excludes(view);
  parser.add_option("--scene", words.scene_file, "A saved scene; other options change it")
      ->type_name("FILE.json")
      ->group(looking);
  parser.add_flag("--parallel", words.parallel, "Parallel instead of perspective projection")->group(looking);
  parser.add_option("--zoom", words.zoom, "So many times nearer")
      ->type_name("F")
      ->check(CLI::Range(0.01, 100.0).description(""))
      ->group(looking);
  repeatable(parser.add_option("--hide", words.hide, "Leave a structure out; repeatable"))
      ->type_name("S")
      ->group(showing);
  repeatable(parser.add_option("--opacity", words.opacity, "0 clear to 1 solid, e.g. enamel=0.3; repeatable"))
      ->type_name("S=F")
      ->group(showing);
  repeatable(parser.add_option("--colour", words.colour, "e.g. pulp=#c9332e; repeatable"))
      ->type_name("S=#RRGGBB")
      ->group(showing);
  parser
      .add_option("--section", words.section, "Cut away: +x to -z, buccal, ..., or X,Y,Z; @MM says where, e.g. -x@2.5")
      ->type_name("SIDE[@MM]")
      ->group(showing);
  parser.add_option("--cap", words.cap, "On the cut: material (default), plain, or CT values: ct, ct=BLACK,WHITE")
      ->type_name("WHAT")
      ->group(showing);
  parser
      .add_option("--cull", words.back_faces,
                  "Faces seen from behind: on (leave out, default), off (show), tint (alarm)")
      ->type_name("MODE")
      ->group(showing);
  parser.add_flag("--wire", words.wire, "Draw the triangles' edges")->group(showing);
  parser.add_flag("--wall-depth", words.wall_depth, "Canals' walls tell their depth: colour, a ring every mm")
      ->group(showing);
  parser
      .add_flag("--wall-thickness", words.wall_thickness, "Walls tell how thick they are: colour, a line every 0.2 mm")
      ->group(showing);
  repeatable(
      parser.add_option("--overlay", words.overlays, "contours, edges (faulty ones), tetrahedra[=SLAB]; repeatable"))
      ->type_name("WHAT")
      ->group(showing);
  parser.add_option("--occlusion", words.occlusion, "Darkening of hollows: 0 none, 1 natural (default), up to 4")
      ->type_name("F")
      ->check(CLI::Range(0.0, 4.0).description(""))
      ->group(showing);
  parser
      .add_option("--background", words.background,
                  "white, black, transparent, #RRGGBB, or two colours from top to bottom")
      ->type_name("COLOUR")
      ->group(showing);
}

}  // namespace odontoscope::app
