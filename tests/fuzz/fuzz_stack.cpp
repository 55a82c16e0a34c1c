// Any bytes: a stack that passes every check and survives writing, or InputError. Anything else is a find.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "recon/input/stack_json.h"
#include "recon/input/validate.h"

using namespace odontoscope;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void round_trip(const ContourStack& stack) {
  const std::string text = to_json(stack);
  const ContourStack again = parse_stack(text, "again");
  validate(again);
  require(to_json(again) == text);
}

void order(const ContourStack& stack) {
  const OrderedStack sorted = ordered(stack);
  validate(sorted.stack);
  require(std::is_sorted(sorted.stack.slices.begin(), sorted.stack.slices.end(),
                         [](const Slice& a, const Slice& b) { return a.z < b.z; }));
  require(structures_of(together(stack, structures_of(stack))).size() == 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const ContourStack stack = parse_stack({reinterpret_cast<const char*>(data), size}, "fuzz");
    validate(stack);
    round_trip(stack);
    order(stack);
  } catch (const InputError&) {
  }
  return 0;
}
