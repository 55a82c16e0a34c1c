#pragma once
// The options of the DB method, which `reconstruct` and `compare` have in common.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "recon/distance/db_reconstruction.h"

namespace odontoscope::app {

/// As typed; not yet understood.
struct DbWords {
  std::string grid;  // "N" or "NxM"; empty: the default
  std::optional<CaseTable> cases;
  std::optional<FieldKind> field;
  std::vector<double> splits;
  std::string decimate;  // "T" or "max"; empty: none

  bool any() const { return !grid.empty() || cases || field || !splits.empty() || !decimate.empty(); }
};

/// --grid, --cases, --field, --split and --decimate.
void add_db_options(CLI::App& parser, DbWords& words);

/// Throws UsageError for a grid or an aim that is none. Whether the grid fits is for make_grid to say.
DbOptions understood(const DbWords& words, int threads);

}  // namespace odontoscope::app
