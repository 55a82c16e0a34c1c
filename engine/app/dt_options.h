#pragma once
// The options of the DT method, which all commands that reconstruct contours have in common.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "engine/app/command.h"
#include "engine/app/link_words.h"
#include "engine/app/partition_options.h"
#include "recon/delaunay/reconstruct.h"

namespace odontoscope::app {

/// As typed; not yet understood.
struct DtWords {
  std::optional<Correspondence> correspondence;
  std::optional<Between> between;
  std::string links;  // file; empty: none
  LinkWords link_words;

  PartitionWords partition;  // where the command offers it

  bool any() const { return correspondence || between || !links.empty() || link_words.any(); }
};

/// --correspondence, --between, --links, --link and --unlink.
void add_dt_options(CLI::App& parser, DtWords& words);

/// UsageError for a link that is none, and for choices that a partition does not know, before any work.
void refuse_senseless(const DtWords& words);

/// UsageError if there are any, for an input that is reconstructed by nobody.
void refuse_for_mesh(const DtWords& words, const std::string& file);

/// The model that the words ask for: each structure by itself, or a partition; if they leave it open, a partition where
/// structures share walls or overlap (each by itself, with a warning, if none comes of it). Links are checked against
/// the contours. Throws as the readers of links do.
Reconstruction reconstructed(const ValidStack& stack, const DtWords& words, Session& session);

/// For these contours: links are checked against them. Throws as the readers of links do.
ReconstructOptions understood(const DtWords& words, const ValidStack& stack, const Session& session);

}  // namespace odontoscope::app
