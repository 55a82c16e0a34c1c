#include "engine/app/db_options.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "engine/app/options.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/distance/limits.h"

namespace odontoscope::app {
namespace {

std::optional<std::size_t> whole(std::string_view text, std::size_t least, std::size_t most) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < least || number > most) return std::nullopt;
  return number;
}

GridOptions grid_in(const std::string& text) {
  GridOptions grid;
  if (text.empty()) return grid;
  const std::size_t cross = text.find('x');
  const auto columns =
      whole(std::string_view(text).substr(0, cross), limits::least_grid_points, limits::most_grid_points);
  const auto rows = cross == std::string::npos ? columns
                                               : whole(std::string_view(text).substr(cross + 1),
                                                       limits::least_grid_points, limits::most_grid_points);
  if (!columns || !rows) {
    throw UsageError(fmt::format("--grid {}: that is no number of grid points", text),
                     fmt::format("Write N or NxM, such as 128 or 128x96, each from {} to {}", limits::least_grid_points,
                                 limits::most_grid_points));
  }
  grid.columns = *columns;
  grid.rows = *rows;
  return grid;
}

std::optional<DecimateOptions> decimation_in(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text == "max") return DecimateOptions{};
  const auto triangles = whole(text, 1, limits::triangles);
  if (triangles) return DecimateOptions{.triangles = triangles, .largest_error = 0};
  throw UsageError(fmt::format("--decimate {}: that is neither a number of triangles nor max", text),
                   "For example --decimate 8000, or --decimate max");
}

}  // namespace

void add_db_options(CLI::App& parser, DbWords& words) {
  const std::string group = "DB method";
  parser.add_option("--grid", words.grid, "Grid points along x and y (default: 128)")->type_name("N|NxM")->group(group);
  add_choice(parser, "--cases", words.cases, case_tables,
             "Marching cubes: classic (default), classic-unoriented or consistent")
      ->type_name("NAME")
      ->group(group);
  add_choice(parser, "--field", words.field, field_kinds,
             "What the grid holds: hybrid (default), signed-distance or sign")
      ->type_name("NAME")
      ->group(group);
  repeatable(parser.add_option("--split", words.splits, "Height of an empty layer that ends what it parts; repeatable"))
      ->type_name("Z")
      ->group(group);
  parser
      .add_option("--decimate", words.decimate, "At most T triangles in all, or as few as half a grid spacing allows")
      ->type_name("T|max")
      ->group(group);
}

DbOptions understood(const DbWords& words, int threads) {
  DbOptions options;
  options.grid = grid_in(words.grid);
  options.grid.splits = words.splits;
  if (words.cases) options.cases = *words.cases;
  if (words.field) options.field.kind = *words.field;
  options.decimation = decimation_in(words.decimate);
  options.threads = threads;
  return options;
}

}  // namespace odontoscope::app
