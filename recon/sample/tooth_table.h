#pragma once
// The tables of the sample teeth, assets/teeth/*.json, and their reader.
//
//   {"format":"odontoscope.tooth","version":1,"kind":"molar","tooth":"lower left first molar (FDI 36)","fdi":"36",
//    "proportions":{...},"top_z":21.5,...,"roots":[{"name":"mesial","apex_z":0,"x":[[0,1.7],[2.5,2.65]],...}],...}
//
// Keys are the members of ToothShape (recon/sample/tooth_shape.h), with its axes and units. A profile is a list of
// knots [z, value] by strictly ascending z; a constant is one knot. What has a default there may be left out of
// "enamel", "cusps" and "landmarks"; all else must be said. Keys that begin with "x-" are notes.

#include <string>
#include <string_view>

#include "recon/sample/tooth_shape.h"

namespace odontoscope::sample {

/// `name` stands for the file in messages. Throws InputError: what recon/input/strict_json.h names, bad-profile,
/// bad-value (a word that is none of those known, a canal in a root that is not there, or a number out of its range).
ToothShape read_tooth_table(std::string_view bytes, const std::string& name);

/// One of those that are part of the program.
ToothShape tooth_shape(ToothKind kind);

}  // namespace odontoscope::sample
