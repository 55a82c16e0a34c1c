#include "engine/scene/data_colours.h"

#include <fmt/format.h>

#include "recon/core/error.h"

namespace odontoscope {

const char* name(DataColours::Of of) { return of == DataColours::Of::slope ? "slope" : "distance"; }

DataColours::Of data_colours_named(std::string_view wanted) {
  for (const DataColours::Of of : {DataColours::Of::distance, DataColours::Of::slope})
    if (wanted == name(of)) return of;
  throw UsageError(fmt::format("there is nothing called \"{}\" to colour surfaces by", wanted),
                   "Choose distance or slope.");
}

}  // namespace odontoscope
