#include "engine/app/batch_record.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/app/version.h"
#include "recon/core/error.h"
#include "recon/core/read_file.h"

namespace odontoscope::app {
namespace {

namespace fs = std::filesystem;
using BatchJson = nlohmann::ordered_json;

constexpr std::size_t most_record_bytes = 1u << 20, most_report_bytes = 1u << 30;

void add_file(const fs::path& file, BatchRecord& record) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (error) return;
  const auto time = fs::last_write_time(file, error);
  if (error) return;
  record.bytes += size;
  record.modified =
      std::max(record.modified, static_cast<std::int64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(
                                                              std::chrono::file_clock::to_sys(time).time_since_epoch())
                                                              .count()));
}

/// No exception for what is no JSON.
BatchJson parsed(const std::string& file, std::size_t most_bytes) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return BatchJson(nlohmann::detail::value_t::discarded);
  return BatchJson::parse(read_file(file, most_bytes), nullptr, false);
}

std::string batch_text_of(const BatchJson& json) {
  return json.dump(2, ' ', false, BatchJson::error_handler_t::replace) + "\n";
}

BatchJson json_of(const BatchRecord& record) {
  BatchJson json{{"name", record.name},       {"input", record.input},       {"words", record.words},
                 {"outputs", record.outputs}, {"input_bytes", record.bytes}, {"input_modified", record.modified},
                 {"program", record.program}, {"exit", record.exit_code},    {"ending", record.ending},
                 {"made", record.made}};
  if (!record.cause.empty()) json["cause"] = record.cause;
  if (!record.message.empty()) json["message"] = record.message;
  json["seconds"] = record.seconds;
  json["mebibytes"] = record.megabytes;
  if (!record.verdict.empty()) json["verdict"] = record.verdict;
  if (record.certified) json["certified"] = *record.certified;
  if (record.made) json["triangles"] = record.triangles, json["tetrahedra"] = record.tetrahedra;
  return json;
}

template <class Value>
void take(const BatchJson& json, const char* key, Value& value) {
  if (json.contains(key)) value = json.at(key).get<Value>();
}

bool outputs_are_there(const BatchRecord& record) {
  std::error_code error;
  return std::all_of(record.outputs.begin(), record.outputs.end(),
                     [&](const std::string& file) { return fs::is_regular_file(file, error); });
}

}  // namespace

void stamp(BatchRecord& record) {
  record.bytes = 0;
  record.modified = 0;
  record.program = ODONTOSCOPE_VERSION;
  std::error_code error;
  if (!fs::is_directory(record.input, error)) return add_file(record.input, record);
  for (fs::recursive_directory_iterator entry(record.input, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (entry->is_regular_file(gone)) add_file(entry->path(), record);
  }
}

void take_report(BatchRecord& record, const std::string& report) {
  try {
    const BatchJson json = parsed(report, most_report_bytes);
    if (!json.is_object()) return;
    take(json, "verdict", record.verdict);
    if (json.contains("certified")) record.certified = json.at("certified").get<bool>();
    if (json.contains("surface")) take(json.at("surface"), "triangles", record.triangles);
    if (json.contains("tetrahedra")) take(json.at("tetrahedra"), "kept", record.tetrahedra);
  } catch (const nlohmann::json::exception&) {
    // Written by a child that was ended: it has no more to say.
  }
}

std::string record_text(const BatchRecord& record) {
  BatchJson json{{"format", "odontoscope.batch-item"}, {"version", 1}};
  json.update(json_of(record));
  return batch_text_of(json);
}

std::optional<BatchRecord> read_record(const std::string& file) try {
  const BatchJson json = parsed(file, most_record_bytes);
  if (!json.is_object() || json.value("format", "") != "odontoscope.batch-item" || json.value("version", 0) != 1)
    return {};
  BatchRecord record;
  take(json, "name", record.name);
  take(json, "input", record.input);
  take(json, "words", record.words);
  take(json, "outputs", record.outputs);
  take(json, "input_bytes", record.bytes);
  take(json, "input_modified", record.modified);
  take(json, "program", record.program);
  take(json, "exit", record.exit_code);
  take(json, "ending", record.ending);
  take(json, "made", record.made);
  take(json, "cause", record.cause);
  take(json, "message", record.message);
  take(json, "seconds", record.seconds);
  take(json, "mebibytes", record.megabytes);
  take(json, "verdict", record.verdict);
  if (json.contains("certified")) record.certified = json.at("certified").get<bool>();
  take(json, "triangles", record.triangles);
  take(json, "tetrahedra", record.tetrahedra);
  return record;
} catch (const nlohmann::json::exception&) {
  return {};
} catch (const Error&) {
  return {};
}

bool is_done(const BatchRecord& found, const BatchRecord& wanted) {
  const bool same = found.input == wanted.input && found.words == wanted.words && found.outputs == wanted.outputs &&
                    found.bytes == wanted.bytes && found.modified == wanted.modified && found.program == wanted.program;
  return same && found.made && outputs_are_there(wanted);
}

std::string batch_report_text(const std::vector<BatchRecord>& records, const std::string& part) {
  std::size_t made = 0, amber = 0, kept = 0;
  BatchJson items = BatchJson::array();
  for (const BatchRecord& record : records) {
    made += record.made;
    amber += record.made && record.verdict == "amber";
    kept += record.kept;
    items.push_back(json_of(record));
    items.back()["kept"] = record.kept;
  }
  BatchJson json{{"format", "odontoscope.batch"}, {"version", 1}};
  if (!part.empty()) json["part"] = part;
  json["counts"] = {
      {"inputs", records.size()}, {"made", made}, {"kept", kept}, {"amber", amber}, {"failed", records.size() - made}};
  json["items"] = std::move(items);
  return batch_text_of(json);
}

}  // namespace odontoscope::app
