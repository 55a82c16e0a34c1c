#pragma once
// What `contours` and `reconstruct` have in common: contours from other programs' contour files, and from meshes cut by
// planes.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/structure_files.h"
#include "recon/input/validate.h"

namespace odontoscope::app {

/// As typed.
struct ForeignWords {
  std::optional<double> spacing_z;      // mm, for meshes
  std::vector<double> heights;          // mm, instead of a spacing
  std::vector<std::string> structures;  // to keep; all if empty
  bool repair = false;
  std::optional<double> widest_gap;  // mm, for meshes

  bool any() const { return spacing_z || !heights.empty() || !structures.empty() || repair || widest_gap; }
};

void add_foreign_options(CLI::App& parser, ForeignWords& words);

/// UsageError for options that contradict each other, or that are about something else than what is read.
void refuse_senseless(const ForeignWords& words, bool of_volume);

/// Is it a contour file of another program? False for what is no plain file, or cannot be read.
bool is_contour_file(const std::string& file);

/// Does it begin like a volume, and no structure set? False as for is_contour_file.
bool begins_like_a_volume(const std::string& file);

/// Is the file something else than a contour stack of ours, or do `words` ask for more than reading it? False for what
/// cannot be looked into without using it up (pipes), or cannot be read.
bool needs_conversion(const std::string& file, const ForeignWords& words);

/// Contours of a mesh, of another program's contour file, or of a stack of ours, repaired if `words` say so; tells what
/// was found, left out and changed. Valid. `whence`, if not null, is told whose structure set it was. UsageError for a
/// mesh without planes, and for a volume.
ValidStack converted_told(const std::string& file, const ForeignWords& words, Session& session,
                          Whence* whence = nullptr);

/// Contours of several meshes of one place, cut by the same planes: each file's mesh is a structure called after its
/// file, several in one file keep their names. UsageError for what is no mesh, and for one name in two files.
ValidStack meshes_told(const std::vector<std::string>& files, const ForeignWords& words, Session& session);

}  // namespace odontoscope::app
