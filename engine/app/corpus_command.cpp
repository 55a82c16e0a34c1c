#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/app/child_run.h"
#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/words.h"
#include "recon/core/limits.h"

namespace odontoscope::app {
namespace {

namespace fs = std::filesystem;

struct CorpusArguments {
  std::string folder;
  ChildBounds bounds;
  std::vector<std::string> outputs;
};

struct Row {
  std::string file, reader;
  ChildEnding ending;
  std::string cause;  // in brackets at the end of a message; empty if there is none
};

/// Plain files of a folder and those below, by name; links are not followed.
std::vector<std::string> files_in(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw FileError(folder, "is no folder", "Give a folder of files to be read");
  std::vector<std::string> files;
  const auto skip = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator entry(folder, skip, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone;
    if (entry->is_symlink(gone) || !entry->is_regular_file(gone)) continue;
    files.push_back(entry->path().string());
    if (files.size() > limits::dicom_files * 10)
      throw FileError(folder, "holds too many files", "Give a smaller folder");
  }
  if (error) throw FileError(folder, "cannot be listed: " + error.message(), "Check its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

std::string cause_in(const std::string& message) {
  const std::size_t end = message.find_last_not_of(" \n"), from = message.rfind('[');
  if (end == message.npos || message[end] != ']' || from == message.npos || from > end) return {};
  return message.substr(from + 1, end - from - 1);
}

/// By `check` what it judges, by `contours --histogram` what is, or may be, a volume.
Row read_apart(const std::string& file, const ChildBounds& bounds, const std::stop_token& stop) {
  Row row{file, "check", run_again({"check", "--threads", "1", file}, bounds, stop), {}};
  row.cause = cause_in(row.ending.err);
  const bool may_be_volume = row.ending.exit_code == static_cast<int>(ExitCode::usage) || row.cause == "unknown-format";
  if (!may_be_volume) return row;
  Row volume{file, "contours", run_again({"contours", "--threads", "1", file, "--histogram"}, bounds, stop), {}};
  volume.cause = cause_in(volume.ending.err);
  return volume;
}

std::vector<Row> rows_of(const std::vector<std::string>& files, const CorpusArguments& options, Session& session) {
  std::vector<Row> rows(files.size());
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex telling;
  std::exception_ptr failed;
  const Progress progress = session.progress();
  const auto work = [&] {
    try {
      for (std::size_t n; (n = next++) < files.size();) {
        rows[n] = read_apart(files[n], options.bounds, progress.stop);
        const std::lock_guard lock(telling);
        progress.tell("read", static_cast<double>(++done) / static_cast<double>(files.size()));
      }
    } catch (...) {
      const std::lock_guard lock(telling);
      failed = std::current_exception();
      next = files.size();
    }
  };
  const unsigned at_once =
      session.threads > 0 ? static_cast<unsigned>(session.threads) : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (unsigned n = 0; n < at_once; ++n) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (failed) std::rethrow_exception(failed);
  return rows;
}

std::string quoted(const std::string& text, bool as_csv) {
  std::string quoted;
  for (const char c : text) {
    if (as_csv && c == '"') quoted += '"';
    if (!as_csv && c == '|') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return as_csv ? "\"" + quoted + "\"" : quoted;
}

std::string table_of(const std::vector<Row>& rows, bool as_csv) {
  std::string text = as_csv ? "file,reader,exit,cause,seconds,mebibytes\n"
                            : "| file | reader | exit | cause | seconds | MiB |\n|---|---|---|---|---|---|\n";
  for (const Row& row : rows) {
    const char* form = as_csv ? "{},{},{},{},{:.3f},{:.1f}\n" : "| {} | {} | {} | {} | {:.3f} | {:.1f} |\n";
    text += fmt::format(fmt::runtime(form), quoted(row.file, as_csv), row.reader, row.ending.in_words(),
                        quoted(row.cause, as_csv), row.ending.seconds, row.ending.megabytes);
  }
  return text;
}

void tell(const std::vector<Row>& rows, Console& console) {
  std::map<std::pair<std::string, std::string>, std::size_t> counts;
  for (const Row& row : rows) ++counts[{row.ending.in_words(), row.cause}];
  for (const auto& [ending, count] : counts)
    console.say(fmt::format("  {:>6}  exit {}{}", count, ending.first,
                            ending.second.empty() ? "" : " [" + ending.second + "]"));
  if (rows.empty()) return;
  const auto slowest = std::max_element(rows.begin(), rows.end(),
                                        [](const Row& a, const Row& b) { return a.ending.seconds < b.ending.seconds; });
  const auto largest = std::max_element(
      rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.ending.megabytes < b.ending.megabytes; });
  console.say(fmt::format("  longest {:.2f} s: {}", slowest->ending.seconds, slowest->file));
  console.say(fmt::format("  most memory {:.0f} MiB: {}", largest->ending.megabytes, largest->file));
}

ExitCode read_corpus(const CorpusArguments& options, Session& session) {
  for (const std::string& output : options.outputs) known_ending(output, {".csv", ".md"});
  refuse_unwritable({.inputs = {}, .outputs = options.outputs});
  const std::vector<Row> rows = rows_of(files_in(options.folder), options, session);
  std::vector<FileContent> tables;
  for (const std::string& output : options.outputs)
    tables.push_back({output, table_of(rows, known_ending(output, {".csv", ".md"}) == ".csv")});
  write_all(tables, session.interrupts);
  session.console.say(fmt::format("{}: {}", options.folder, counted(rows.size(), "file")));
  tell(rows, session.console);
  std::size_t bad = 0;
  for (const Row& row : rows) {
    if (!row.ending.is_bad()) continue;
    ++bad;
    session.console.say(fmt::format("  ended in {}: {} {}", row.ending.in_words(), row.reader, row.file));
  }
  session.console.say(bad == 0 ? "none ended in a signal, a hang or a bug of ours"
                               : fmt::format("{} ended in a signal, a hang or a bug of ours", counted(bad, "file")));
  return bad == 0 ? ExitCode::done : ExitCode::found_wanting;
}

}  // namespace

Command corpus_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand(
      "corpus", "Read every file of a folder, each in a process of its own, and say what became of it");
  const auto options = std::make_shared<CorpusArguments>();
  parser->add_option("FOLDER", options->folder, "Files and those in folders below; links are not followed")
      ->required()
      ->type_name("");
  parser->add_option("--timeout", options->bounds.seconds, "Most seconds for a file (default: 60)")
      ->type_name("S")
      ->check(at_least_zero());
  constexpr int most_megabytes = 1 << 20;
  parser->add_option("--memory", options->bounds.megabytes, "Most memory for a file, MB (default: 4096)")
      ->type_name("MB")
      ->check(whole_number_from_one_to(most_megabytes));
  repeatable(parser->add_option("-o,--output", options->outputs, "A table of all, .csv or .md; repeatable"))
      ->type_name("FILE");
  parser->footer(
      "Examples:\n"
      "  odontoscope corpus Downloads\n"
      "  odontoscope corpus /usr/share --timeout 10 --memory 1000 -o usr-share.csv\n"
      "\n"
      "Meshes and contours are read as check reads them, volumes as contours --histogram does. Most files of a\n"
      "folder are none of these, and end in exit code 3 with a reason. The exit code is 1 if any ended in a\n"
      "signal, took too long, or met a bug of ours (70).\n");
  return {parser, [options](Session& session) { return read_corpus(*options, session); }};
}

}  // namespace odontoscope::app
