#include "recon/sample/tooth_table.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "recon/core/embedded_file.h"
#include "recon/core/error.h"
#include "recon/input/json_source.h"
#include "recon/input/strict_json.h"
#include "recon/sample/tooth_schema.h"

namespace odontoscope {

std::span<const EmbeddedFile> tooth_files();  // assets/teeth, made part of the program

}  // namespace odontoscope

namespace odontoscope::sample {
namespace {

class ToothTableReader final : public StrictJson {
 public:
  explicit ToothTableReader(ToothSchema& schema) : StrictJson(schema.nodes), schema_(schema) {
    schema_.refuse = [this](std::string_view cause, const std::string& wrong, std::string_view remedy) {
      StrictJson::refuse(cause, wrong, remedy);
    };
  }

 private:
  const ToothEffect& effect(int node) const { return schema_.effects[static_cast<std::size_t>(node)]; }
  void opened(int node) override {
    if (effect(node).opened) effect(node).opened();
  }
  void closed(int node) override {
    if (effect(node).closed) effect(node).closed();
  }
  void number(int node, double value) override {
    if (effect(node).number) effect(node).number(value);
  }
  void count(int node, std::uint64_t value) override { number(node, static_cast<double>(value)); }
  void text(int node, const std::string& value) override {
    if (effect(node).text) effect(node).text(value);
  }

  ToothSchema& schema_;
};

}  // namespace

ToothShape read_tooth_table(std::string_view bytes, const std::string& name) {
  ToothSchema schema;
  JsonSource source = JsonSource::from_bytes(bytes, name);
  ToothTableReader(schema).read(source);
  return std::move(schema.tooth);
}

ToothShape tooth_shape(ToothKind kind) {
  const std::string file = std::string(name(kind)) + ".json";
  for (const EmbeddedFile& table : tooth_files())
    if (table.name == file) return read_tooth_table(table.bytes, file);
  throw UsageError("unknown kind of sample tooth", "Choose molar, premolar or incisor");
}

}  // namespace odontoscope::sample
