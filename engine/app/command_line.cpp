#include "engine/app/command_line.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/spelling.h"
#include "engine/app/version.h"
#include "recon/core/system_processes.h"

namespace odontoscope::app {
namespace {

constexpr const char* purpose =
    "Odontoscope turns stacks of planar contours of a tooth, or a CT volume, into solid models\n"
    "whose surface is proven to be a closed, oriented manifold.\n";

struct GlobalOptions {
  bool quiet = false;
  int threads = 0;
};

void add_global_options(CLI::App& root, GlobalOptions& options) {
  constexpr int most_threads = 1024;
  root.set_version_flag("--version", ODONTOSCOPE_VERSION, "Print the version and leave");
  root.add_flag("-q,--quiet", options.quiet, "Say nothing but errors");
  root.add_option("--threads", options.threads, "Threads to use; the result does not depend on it (default: all)")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_threads));
}

const CLI::App* chosen_subcommand(const CLI::App& root) {
  const auto chosen = root.get_subcommands();
  return chosen.empty() ? nullptr : chosen.front();
}

/// The first word that is no option; --threads has a value.
std::string first_word(const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--threads")
      ++i;
    else if (!arguments[i].starts_with('-'))
      return arguments[i];
  }
  return {};
}

std::string on_missing_subcommand(const CLI::App& root, const std::vector<std::string>& arguments) {
  const std::string word = first_word(arguments);
  if (word.empty()) return "nothing says what to do";
  std::error_code error;
  if (const auto meant = similar_subcommand(word, root)) {
    return fmt::format("{} is no subcommand. Did you mean {}?", word, *meant);
  }
  if (std::filesystem::exists(word, error)) {
    return fmt::format("{} is no subcommand. To make a model of it: odontoscope reconstruct {} -o OUT.glb", word, word);
  }
  return fmt::format("{} is no subcommand", word);
}

std::string on_unexpected(const CLI::App& root, const CLI::App& chosen) {
  const std::vector<std::string> unexpected = root.remaining(true);
  for (const std::string& argument : unexpected) {
    if (!argument.starts_with('-')) continue;
    const auto meant = similar_option(argument, {&root, &chosen});
    return fmt::format("{} has no option {}{}", chosen.get_name(), argument,
                       meant ? fmt::format(". Did you mean {}?", *meant) : "");
  }
  return fmt::format(
      "{} is one argument too many. Options that may be repeated want their name each time, as in -o A -o B",
      unexpected.empty() ? "there" : unexpected.front());
}

void explain_usage(Console& console, const CLI::App& root, const std::vector<std::string>& arguments,
                   const CLI::ParseError& error) {
  const CLI::App* chosen = chosen_subcommand(root);
  std::string wrong = error.what();
  const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  if (chosen == nullptr && (is_extra || dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)) {
    wrong = on_missing_subcommand(root, arguments);
  } else if (chosen != nullptr && is_extra) {
    wrong = on_unexpected(root, *chosen);
  }
  if (wrong.back() != '?') wrong += '.';
  console.complain(
      fmt::format("{}\nSee odontoscope{}{} --help.", wrong, chosen ? " " : "", chosen ? chosen->get_name() : ""));
}

/// "help" and "help view" are what "--help" and "view --help" say.
std::vector<std::string> without_help_word(std::vector<std::string> arguments) {
  if (arguments.front() != "help") return arguments;
  arguments.erase(arguments.begin());
  arguments.push_back("--help");
  return arguments;
}

/// Elsewhere "-" stands for what comes in or goes out. Files are written whole or not at all, and read more than once:
/// that takes names.
void refuse_dash(const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] != "-") continue;
    const bool output = i > 0 && (arguments[i - 1] == "-o" || arguments[i - 1] == "--output");
    if (!output && i > 0 && arguments[i - 1].starts_with("-")) continue;  // some other option's value
    throw CLI::ValidationError(
        output ? "-o -: nothing is written to standard output. Give the file a name; its ending says the format"
               : "-: nothing is read from standard input. Give the name of a file");
  }
}

/// The exit code if the program is over after reading its command line.
std::optional<int> parse(CLI::App& root, Console& console, int argc, char** argv) {
  const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments.empty()) {
    const std::string help = root.help();
    std::fwrite(help.data(), 1, help.size(), stderr);
    return static_cast<int>(ExitCode::usage);
  }
  try {
    refuse_dash(arguments);
    const std::vector<std::string> meant = without_help_word(arguments);
    root.parse(std::vector<std::string>(meant.rbegin(), meant.rend()));  // which takes them from the end
    return std::nullopt;
  } catch (const CLI::Success& asked) {  // --help, --version
    root.exit(asked);
    console.finish();
    return static_cast<int>(ExitCode::done);
  } catch (const CLI::ParseError& error) {
    explain_usage(console, root, arguments, error);
    return static_cast<int>(ExitCode::usage);
  }
}

const Command& chosen_of(const std::vector<Command>& commands) {
  const auto chosen =
      std::find_if(commands.begin(), commands.end(), [](const Command& c) { return c.parser->parsed(); });
  if (chosen == commands.end()) throw InternalError("no subcommand was chosen");
  return *chosen;
}

int run_command(const Command& command, Session& session) try {
  const int threads = session.threads > 0 ? session.threads : tbb::this_task_arena::max_concurrency();
  const tbb::global_control no_more(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  const ExitCode code = arena.execute([&] { return command.run(session); });
  session.console.finish(session.interrupts.has_written());
  return static_cast<int>(code);
} catch (const UsageError& error) {
  session.console.complain(fmt::format("{}\nSee odontoscope {} --help.", error.what(), command.parser->get_name()));
  return static_cast<int>(error.exit_code());
}

/// The system refuses memory in several ways: a thread that cannot be started is one.
bool tells_of_memory(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && (system->code() == std::errc::not_enough_memory ||
                               system->code() == std::errc::resource_unavailable_try_again);
}

int parse_and_run(Console& console, Interrupts& interrupts, int argc, char** argv) {
  CLI::App root(purpose, "odontoscope");
  root.footer(first_steps());
  root.require_subcommand(1);
  root.get_formatter()->column_width(36);
  GlobalOptions options;
  add_global_options(root, options);
  const std::vector<Command> commands = add_commands(root);
  for (const Command& command : commands)
    command.parser->fallthrough();  // --quiet and --threads may stand behind the subcommand too
  if (const auto over = parse(root, console, argc, argv)) return *over;
  if (options.quiet) console.be_quiet();
  Session session{console, interrupts, options.threads, {}};
  return run_command(chosen_of(commands), session);
}

}  // namespace

int run(int argc, char** argv) {
  system::occupy_closed_standard_files();  // and Console::finish tells of words that were lost there
  system::let_writes_fail();
  std::optional<Interrupts> interrupts;
  Console console;
  const auto end = [&console](ExitCode code, std::string_view message) {
    console.complain(message);
    return static_cast<int>(code);
  };
  try {
    interrupts.emplace();  // starts a thread, for which there may be no memory
    return parse_and_run(console, *interrupts, argc, argv);
  } catch (const Cancelled&) {
    console.complain("stopped; no file was touched.");
    return interrupted_exit_code;
  } catch (const Error& error) {
    return end(error.exit_code(), error.what());
  } catch (const std::exception& error) {
    if (tells_of_memory(error)) {
      return end(ExitCode::file,
                 "this machine has not enough memory for that input. Make it smaller: fewer slices, contours "
                 "--simplify, a larger --min-area; "
                 "of a volume --crop or --resample. [out-of-memory]");
    }
    return end(ExitCode::internal, InternalError(error.what()).what());
  } catch (...) {
    return end(ExitCode::internal, InternalError("an unknown exception").what());
  }
}

}  // namespace odontoscope::app
