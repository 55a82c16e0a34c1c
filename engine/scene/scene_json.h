#pragma once
// Scenes as files: saved from the viewer, given to `render`, tied to golden pictures.
//
//   {"format":"odontoscope.scene","version":1,
//    "camera":{"projection":"perspective","position":[0,60,10],"target":[0,0,10],"up":[0,0,1],
//              "field_of_view_deg":24,"height_mm":25},
//    "structures":[{"name":"enamel","colour":"#e3edf2","opacity":0.3,"visible":true,"as_body":false}],
//    "section":{"point":[0,0,10],"normal":[0,1,0]},
//    "cap":{"shows":"ct","window":[60,220]},
//    "volume":{"shows":"both","cast":"shaded","transfer":[{"value":90,"colour":"#e8b56a","extinction":0},{"value":160,"colour":"#e8b56a","extinction":2}],
//              "lit":true,"window":[60,220],"attenuation":0.23,"latitude":4,"iso":120,"iso_colour":"#eddebd"},
//    "back_faces":"cull","wire":false,
//    "overlays":{"contours":true,"edges":false,"slab":12,"shrink":0.8},
//    "background":{"kind":"gradient","top":"#c2cfdb","bottom":"#f7fafb"},
//    "ambient_occlusion":{"on":true,"strength":1,"reach":0.12},
//    "headlight":{"reach_mm":1.5},
//    "picture":{"width":1280,"height":960,"samples":9}}
//
// The camera may have "near_mm" as well: an eye between walls (see camera.h).
//
// Every member but format and version may be missing and then keeps its value; unknown members are ignored. Lengths in
// mm.

#include <string>

#include "engine/scene/scene.h"

namespace odontoscope {

std::string to_json(const Scene& scene);

/// `start` with what the file's text says changed. `file` is for messages. Throws InputError: what
/// recon/input/strict_json.h names of a tolerant reading, wrong-version, bad-camera, bad-value.
Scene scene_from_json(const std::string& text, const Scene& start, const std::string& file = {});

/// Reads such a file (FileError if it cannot be read, InputError as above).
Scene read_scene(const std::string& file, const Scene& start);

}  // namespace odontoscope
