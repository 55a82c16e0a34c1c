#include "recon/exchange/contour_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "recon/core/error.h"
#include "recon/exchange/read_csl.h"
#include "recon/exchange/read_jser.h"
#include "recon/exchange/read_rtstruct.h"
#include "recon/exchange/read_series.h"
#include "recon/input/validate.h"

namespace odontoscope {

std::optional<ContourFileKind> contour_file_kind(std::string_view bytes) {
  if (looks_like_rtstruct(bytes)) return ContourFileKind::rtstruct;
  if (looks_like_csl(bytes)) return ContourFileKind::csl;
  if (looks_like_jser(bytes)) return ContourFileKind::jser;
  if (looks_like_series(bytes)) return ContourFileKind::series;
  return std::nullopt;
}

FileContours read_contour_file(ContourFileKind kind, std::string_view bytes, const std::string& file,
                               const std::vector<std::string>& structures) {
  FileContours read;
  switch (kind) {
    case ContourFileKind::series:
      read = read_series(bytes, file);
      break;
    case ContourFileKind::jser:
      read = parse_jser(bytes, file);
      break;
    case ContourFileKind::csl:
      read = parse_csl(bytes, file);
      break;
    case ContourFileKind::rtstruct:
      return parse_rtstruct(bytes, file, structures);  // only planes of those wanted
  }
  keep_structures(read.stack, structures);
  return read;
}

void keep_structures(ContourStack& stack, const std::vector<std::string>& structures) {
  if (structures.empty()) return;
  const std::vector<std::string> there = structures_of(stack);
  for (const std::string& wanted : structures) {
    if (std::find(there.begin(), there.end(), wanted) != there.end()) continue;
    Place place;
    place.file = stack.source;
    throw InputError("unknown-structure", place, fmt::format("there is no structure {}", wanted),
                     fmt::format("Those there are {}", fmt::join(there, ", ")));
  }
  for (Slice& slice : stack.slices) {
    std::erase_if(slice.contours, [&](const Contour& contour) {
      return std::find(structures.begin(), structures.end(), contour.structure) == structures.end();
    });
  }
}

}  // namespace odontoscope
