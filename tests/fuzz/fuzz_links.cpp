// Any bytes: links that survive writing and are judged against a stack, or InputError. Anything else is a find.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "recon/input/links.h"
#include "recon/input/links_json.h"
#include "recon/input/validate.h"

using namespace odontoscope;

namespace {

Contour square(std::string structure, double x, double side) {
  return {std::move(structure), {{x, x}, {x + side, x}, {x + side, x + side}, {x, x + side}}};
}

/// Three slices with two regions, a hole and another structure each.
ContourStack some_stack() {
  ContourStack stack;
  for (const double z : {0.0, 1.0, 2.0}) {
    stack.slices.push_back(
        {z, {square("tooth", 0, 9), square("tooth", 2, 3), square("tooth", 10, 2), square("pulp", 3, 1)}});
  }
  return ordered(stack).stack;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ContourStack stack = some_stack();
  try {
    const std::vector<Link> links = parse_links({reinterpret_cast<const char*>(data), size}, "fuzz");
    std::vector<ReportedLink> reported;
    for (const Link& link : links) reported.push_back({link, "medial"});
    if (parse_links(links_to_json(reported), "again") != links) std::abort();
    validate_links(links, stack, "fuzz");
  } catch (const InputError&) {
  }
  return 0;
}
