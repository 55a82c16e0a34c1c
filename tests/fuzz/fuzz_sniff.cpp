// Any bytes to those who tell a file by its content; whatever they take it for, its reader reads or refuses it.
#include "engine/app/sniff.h"
#include "recon/exchange/contour_file.h"
#include "recon/input/stack_json.h"
#include "tests/fuzz/fuzz_bytes.h"

using namespace odontoscope;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text(data, size);
  fuzz::refused_or_read([&] {
    if (const auto kind = contour_file_kind(bytes)) read_contour_file(*kind, bytes, "/nowhere/fuzz.ser");
  });
  return fuzz::refused_or_read([&] {
    const app::FileKind kind = app::kind_of(bytes);
    if (!app::meshes_in(kind, bytes, "fuzz") && kind == app::FileKind::contour_stack) parse_stack(bytes, "fuzz");
  });
}
