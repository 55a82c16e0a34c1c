#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/app/batch_items.h"
#include "engine/app/batch_record.h"
#include "engine/app/child_run.h"
#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/words.h"
#include "recon/output/model_file.h"

namespace odontoscope::app {
namespace {

namespace fs = std::filesystem;

struct BatchArguments {
  std::vector<std::string> sources;
  std::string folder;
  std::vector<std::string> formats;  // ".glb"
  std::string words;                 // for every `reconstruct`
  std::string part;                  // "K/N"
  int jobs = 0;
  bool anew = false;
  ChildBounds bounds{.seconds = 3600, .megabytes = most_megabytes};

  static constexpr int most_megabytes = 1 << 20;
};

/// This call's share of the inputs: every `of`th, from number `first` on.
struct BatchPart {
  std::size_t first = 0, of = 1;
  std::string suffix;  // of the report's name
};

BatchPart part_in(const std::string& text) {
  if (text.empty()) return {};
  const auto whole = [](std::string_view digits) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return error == std::errc() && end == digits.data() + digits.size() ? number : 0;
  };
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::size_t number = whole(std::string_view(text).substr(0, slash)),
                    of = whole(std::string_view(text).substr(std::min(slash + 1, text.size())));
  if (number >= 1 && number <= of) return {number - 1, of, fmt::format("-{}-of-{}", number, of)};
  throw UsageError(fmt::format("--part {}: that is no part", text),
                   "Write K/N with K from 1 to N, such as --part 3/20");
}

/// Files are named by the batch; what follows here would be lost, or be written over by the next.
void refuse_own_outputs(const std::vector<std::string>& words, const std::string& where) {
  for (const std::string& word : words) {
    const bool output = word.starts_with("-o") || word.starts_with("--output"), report = word.starts_with("--report");
    if (output || report)
      throw UsageError(fmt::format("{}: {} is for the batch to say", where, word),
                       output ? "Choose with --format, as in --format .stl" : "Every model gets its report");
    if (word.starts_with("--threads") || word == "-q" || word == "--quiet")
      throw UsageError(fmt::format("{}: {} is for the batch to say", where, word), "Give it before or after all else");
  }
}

/// What is to be made of an input; nothing of what came of it yet.
BatchRecord planned(const BatchItem& item, const std::vector<std::string>& words, const BatchArguments& options) {
  BatchRecord record;
  record.name = item.name;
  record.input = item.input;
  record.words = words;
  record.words.insert(record.words.end(), item.words.begin(), item.words.end());
  refuse_own_outputs(item.words, item.input);
  const fs::path base = fs::path(options.folder) / item.name;
  for (const std::string& format : options.formats) record.outputs.push_back(base.string() + format);
  record.outputs.push_back(base.string() + ".report.json");
  return record;
}

std::string last_line(std::string_view text) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  return std::string(text.substr(text.rfind('\n') + 1));
}

/// The cause at the end of a message, and the message without the program's name.
void take_message(BatchRecord& record, const std::string& err) {
  std::string line = last_line(err);
  if (line.starts_with("See odontoscope"))
    line = last_line(std::string_view(err).substr(0, err.rfind("See odontoscope")));
  if (line.starts_with("odontoscope: ")) line.erase(0, 13);
  constexpr int no_program = 127;
  record.message = line.empty() && record.exit_code == no_program
                       ? "this program cannot be started once more: /proc is not mounted, or it was replaced meanwhile"
                       : line;
  const std::size_t open = line.rfind('[');
  if (line.ends_with(']') && open != line.npos) record.cause = line.substr(open + 1, line.size() - open - 2);
}

/// Nothing for a file that is not there.
std::optional<fs::file_time_type> written_when(const std::string& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}

void make(BatchRecord& record, const BatchArguments& options, int threads, const std::stop_token& stop) {
  std::vector<std::string> call{"reconstruct", record.input.starts_with('-') ? "./" + record.input : record.input,
                                "--quiet", "--threads", std::to_string(threads)};
  const std::string report = record.outputs.back();
  for (std::size_t n = 0; n + 1 < record.outputs.size(); ++n) call.insert(call.end(), {"-o", record.outputs[n]});
  call.insert(call.end(), {"--report", report});
  call.insert(call.end(), record.words.begin(), record.words.end());
  const auto before = written_when(report);
  const ChildEnding ending = run_again(call, options.bounds, stop);
  record.exit_code = ending.exit_code;
  record.ending = ending.in_words();
  record.seconds = ending.seconds;
  record.megabytes = ending.megabytes;
  // All are written or none: with --strict none, and 1 is the exit code all the same.
  record.made = record.exit_code == 0 || (record.exit_code == 1 && written_when(report) != before);
  if (record.made)
    take_report(record, report);
  else
    take_message(record, ending.err);
}

std::string record_file(const BatchRecord& record, const BatchArguments& options) {
  return (fs::path(options.folder) / (record.name + ".batch.json")).string();
}

/// Keeps what is done, makes the rest, and writes each record as soon as it is known.
void keep_or_make(BatchRecord& record, const BatchArguments& options, int threads, Session& session,
                  const std::stop_token& stop) {
  stamp(record);
  const std::string file = record_file(record, options);
  if (!options.anew) {
    if (auto found = read_record(file); found && is_done(*found, record)) {
      record = std::move(*found);
      record.kept = true;
      return;
    }
  }
  make(record, options, threads, stop);
  write_all({{file, record_text(record)}}, session.interrupts);
}

/// How many at once, and threads for each: by default one each, on every processor.
std::pair<std::size_t, int> shared_out(const BatchArguments& options, const Session& session) {
  const int threads = session.threads > 0 ? session.threads : 1;
  const std::size_t processors = std::max(1u, std::thread::hardware_concurrency());
  return {options.jobs > 0 ? static_cast<std::size_t>(options.jobs)
                           : std::max<std::size_t>(1, processors / static_cast<std::size_t>(threads)),
          threads};
}

/// A failure of one stops none. True if all had their turn; false after Ctrl-C.
bool work_through(std::vector<BatchRecord>& records, std::vector<char>& had_turn, const BatchArguments& options,
                  Session& session) {
  const Progress progress = session.progress();
  const auto [at_once, threads] = shared_out(options, session);
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex telling;
  std::exception_ptr failed;
  bool cancelled = false;
  const auto work = [&, threads = threads] {
    for (std::size_t n; (n = next++) < records.size();) {
      try {
        keep_or_make(records[n], options, threads, session, progress.stop);
        const std::lock_guard lock(telling);
        had_turn[n] = true;
        progress.tell("batch", static_cast<double>(++done) / static_cast<double>(records.size()));
        if (!records[n].made)
          session.console.complain(
              fmt::format("{}: {}", records[n].input,
                          records[n].message.empty() ? "ended in " + records[n].ending : records[n].message));
      } catch (const Cancelled&) {
        const std::lock_guard lock(telling);
        cancelled = true;
        next = records.size();
      } catch (...) {  // the folder cannot be written any more: no use in going on
        const std::lock_guard lock(telling);
        failed = std::current_exception();
        next = records.size();
      }
    }
  };
  std::vector<std::thread> workers;
  for (std::size_t n = 0; n < std::min(at_once, records.size()); ++n) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  if (failed) std::rethrow_exception(failed);
  return !cancelled;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error))
    throw FileError(folder, "is no folder, and none can be made there", "Name another folder");
}

ExitCode tell_batch(const std::vector<BatchRecord>& records, const std::string& report, Console& console) {
  std::size_t made = 0, kept = 0, amber = 0;
  for (const BatchRecord& record : records)
    made += record.made, kept += record.kept, amber += record.made && record.verdict == "amber";
  console.say(
      fmt::format("{}: {} made{}, {} failed{}", counted(records.size(), "input"), made,
                  kept > 0 ? fmt::format(" ({} before)", kept) : "", records.size() - made,
                  amber > 0 ? fmt::format("; {} amber: look at the places that their reports name", amber) : ""));
  console.say(fmt::format("Wrote {}", report));
  return made == records.size() ? ExitCode::done : ExitCode::found_wanting;
}

ExitCode run_batch(BatchArguments options, Session& session) {
  if (options.formats.empty()) options.formats = {".glb"};
  for (std::string& format : options.formats) {
    if (!format.starts_with('.')) format.insert(0, ".");
    known_ending("x" + format, model_endings());
  }
  const BatchPart part = part_in(options.part);
  const std::vector<std::string> words = words_in_line(options.words, "--with");
  refuse_own_outputs(words, "--with");
  const std::vector<BatchItem> items = batch_items(options.sources);
  std::vector<BatchRecord> records;
  for (std::size_t n = part.first; n < items.size(); n += part.of) records.push_back(planned(items[n], words, options));
  make_folder(options.folder);
  const std::string report = (fs::path(options.folder) / ("batch" + part.suffix + ".json")).string();
  refuse_unwritable({.inputs = {}, .outputs = {report}});

  std::vector<char> had_turn(records.size(), false);
  const bool all = work_through(records, had_turn, options, session);
  if (!all) {
    const auto turns = static_cast<std::size_t>(std::count(had_turn.begin(), had_turn.end(), true));
    session.console.complain(fmt::format("stopped after {} of {}. The same call goes on from there.", turns,
                                         counted(records.size(), "input")));
    return static_cast<ExitCode>(interrupted_exit_code);
  }
  write_all({{report, batch_report_text(records, options.part)}}, session.interrupts);
  return tell_batch(records, report, session.console);
}

}  // namespace

Command batch_command(CLI::App& root) {
  CLI::App* parser =
      root.add_subcommand("batch", "Reconstruct many inputs, each in a process of its own, with one report");
  const auto options = std::make_shared<BatchArguments>();
  parser->add_option("INPUT", options->sources, "Files, 'patterns', or lists of them (.txt, .list)")
      ->required()
      ->type_name("");
  parser->add_option("-o,--output", options->folder, "Folder of all that is made")->required()->type_name("DIR");
  repeatable(parser->add_option("--format", options->formats, "What to make of each (default: .glb); repeatable"))
      ->type_name(".END");
  parser->add_option("--with", options->words, "Options of reconstruct for every input")->type_name("'WORDS'");
  parser->add_option("--part", options->part, "Only every Nth input from the Kth on: for arrays of jobs")
      ->type_name("K/N");
  constexpr int most_jobs = 1024;
  parser->add_option("--jobs", options->jobs, "Inputs at once (default: one a processor, a thread each)")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_jobs));
  parser->add_flag("--anew", options->anew, "Make again what is there already");
  parser->add_option("--timeout", options->bounds.seconds, "Most seconds for an input (default: 3600)")
      ->type_name("S")
      ->check(at_least_zero());
  parser->add_option("--memory", options->bounds.megabytes, "Most memory for an input, MB (default: all)")
      ->type_name("MB")
      ->check(whole_number_from_one_to(BatchArguments::most_megabytes));
  parser->footer(
      "Examples:\n"
      "  odontoscope batch 'teeth/*.json' -o models --format .glb --format .vtu\n"
      "  odontoscope batch 'ct/*.nrrd' -o models --with '--iso auto --min-area 4'\n"
      "  odontoscope batch teeth.txt -o models --jobs 4 --threads 2\n"
      "  odontoscope batch teeth.txt -o models --part 3/20      # in a job array; then once more without --part\n"
      "\n"
      "A list has an input a line, and behind it what reconstruct is told for this one alone.\n"
      "Of each input NAME.glb (and so on) and NAME.report.json are made; batch.json tells of all. What fails stops\n"
      "nothing, and makes the exit code 1. The same call again keeps what is done (same input, words and version)\n"
      "and tries the rest. docs/batch.md has examples for Slurm and GNU parallel.\n");
  return {parser, [options](Session& session) { return run_batch(*options, session); }};
}

}  // namespace odontoscope::app
