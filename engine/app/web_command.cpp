#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "engine/app/called_lesson.h"
#include "engine/app/command.h"
#include "engine/app/model_page.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/web_input.h"
#include "engine/app/words.h"
#include "engine/web/studio.h"
#include "recon/core/grouped.h"

namespace odontoscope::app {
namespace {

struct WebArguments {
  WebWords words;
  std::string output, title, lesson, language;
  std::optional<int> budget;  // thousands of bytes
  bool studio = false;
};

constexpr std::size_t longest_title = 200;

/// A lesson in place of a model is about the model that it names, or the sample molar.
std::optional<CalledLesson> lesson_of(WebArguments& options) {
  if (named_like_a_tour(options.words.input)) {
    if (!options.lesson.empty())
      throw UsageError(fmt::format("{} is a lesson, and --lesson names another", options.words.input),
                       "Give one of them");
    std::swap(options.lesson, options.words.input);
  }
  if (options.lesson.empty()) return {};
  CalledLesson lesson = lesson_called(options.lesson);
  if (options.words.input.empty() && !lesson.lesson.model.empty())
    options.words.input =
        (std::filesystem::path(options.lesson).parent_path() / lesson.lesson.model).lexically_normal().string();
  return lesson;
}

std::string title_of(const WebArguments& options, const std::optional<CalledLesson>& lesson) {
  if (!options.title.empty()) return options.title;
  if (lesson && !lesson->lesson.title.empty()) return lesson->lesson.title;
  if (options.words.input.empty()) return "Sample molar";
  std::filesystem::path path(options.words.input);
  if (!path.has_filename()) path = path.parent_path();
  return path.stem().string();
}

void refuse_without_page() {
  const EmbeddedPage page = embedded_page();
  if (!page.html.empty()) return;
  throw UsageError(fmt::format("this odontoscope was built without its web page: {}", page.why),
                   "Install Node.js 18 or newer with npm (Debian: nodejs, npm), see that the npm registry can be "
                   "reached, and build again");
}

struct Made {
  WebPage page;
  std::string html;
};

Made made_once(const WebArguments& options, const std::optional<CalledLesson>& lesson, Session& session) {
  Made made{web_page_of(options.words, session), {}};
  made.page.title = title_of(options, lesson);
  if (lesson) made.page.lesson = to_json(lesson->lesson);
  made.page.lesson_built_in = lesson && lesson->built_in;
  made.page.language = language_in_page(options.language);
  session.progress().check();
  session.progress().tell("page", 0.8);
  made.html = web_page(made.page, embedded_page().html);
  session.progress().check();
  return made;
}

/// As large as --budget allows: simplified until it fits, unless --triangles says how far.
Made made_to_fit(WebArguments options, const std::optional<CalledLesson>& lesson, Session& session) {
  constexpr int tries = 4;
  constexpr double spare = 0.95;  // bytes a triangle vary
  const std::size_t most = options.budget ? 1000 * static_cast<std::size_t>(*options.budget) : std::string::npos,
                    shell = embedded_page().html.size();
  if (most <= shell)
    throw UsageError(fmt::format("--budget {}: the page has {} KB before there is a model in it", *options.budget,
                                 grouped(shell / 1000)),
                     fmt::format("Allow {} or more", grouped(shell / 1000 + 200)));
  Made made = made_once(options, lesson, session);
  const bool may_simplify = !options.words.triangles && made.page.models.front().name == "DT";
  for (int left = tries; made.html.size() > most && may_simplify && left > 0; --left) {
    const double share = spare * static_cast<double>(most - shell) / static_cast<double>(made.html.size() - shell);
    options.words.triangles =
        std::max(1, static_cast<int>(share * static_cast<double>(made.page.models.front().triangles)));
    made = made_once(options, lesson, session);
  }
  if (made.html.size() > most)
    throw UsageError(fmt::format("--budget {}: the page has {} KB", *options.budget, grouped(made.html.size() / 1000)),
                     may_simplify ? "Its surfaces cannot be simplified any further: allow more, or leave out --db"
                                  : "Allow more, or give contours and fewer --triangles");
  return made;
}

/// The same page for everybody: what it makes models of is given to it in the browser.
ExitCode make_studio(const WebArguments& options, Session& session) {
  const WebWords& words = options.words;
  if (!words.input.empty() || !options.title.empty() || !options.lesson.empty() || !options.language.empty() ||
      words.with_db || options.budget || words.triangles || words.with_volume() || words.dt.any() || words.db.any() ||
      words.volume.any_level())
    throw UsageError("--studio: this page takes its input in the browser", "Leave INPUT and the other options out");
  const std::string_view page = studio_page();
  if (page.empty())
    throw UsageError("this odontoscope was built without the studio",
                     "Run web/wasm/build (it needs Debian's emscripten), and build again; docs/studio.md tells more");
  refuse_unwritable({.inputs = {}, .outputs = {options.output}});
  write_all({{options.output, std::string(page)}}, session.interrupts);
  session.console.say(fmt::format(
      "Wrote {} ({} KB). Open it in a browser, and drop contours, a volume or a mesh on it; it needs no network.",
      options.output, grouped(page.size() / 1000)));
  return ExitCode::done;
}

ExitCode make_page(WebArguments options, Session& session) {
  known_ending(options.output, {".html"});
  if (options.studio) return make_studio(options, session);
  if (options.title.size() > longest_title)
    throw UsageError(fmt::format("--title has {} bytes", options.title.size()),
                     fmt::format("Make it {} or less", longest_title));
  const std::optional<CalledLesson> lesson = lesson_of(options);
  language_in_page(options.language);  // told before the work
  refuse_senseless(options.words);
  refuse_without_page();
  PlannedFiles files{.inputs = {}, .outputs = {options.output}};
  if (!options.words.input.empty()) files.inputs.push_back(options.words.input);
  if (!options.lesson.empty() && std::filesystem::exists(options.lesson)) files.inputs.push_back(options.lesson);
  if (!options.words.dt.links.empty()) files.inputs.push_back(options.words.dt.links);
  if (std::filesystem::exists(options.language)) files.inputs.push_back(options.language);
  refuse_unwritable(files);

  const auto [page, html] = made_to_fit(options, lesson, session);
  write_all({{options.output, html}}, session.interrupts);
  for (const WebModel& model : page.models)
    session.console.say(
        fmt::format("{}: {}. {}", model.name, counted(model.triangles, "triangle"), model.certificate.headline));
  session.console.say(
      fmt::format("Wrote {} ({} KB, of which the page itself {}). Open it in a browser; it needs no network.",
                  options.output, grouped(html.size() / 1000), grouped(embedded_page().html.size() / 1000)));
  return ExitCode::done;
}

}  // namespace

Command web_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("web", "A page to look at a model in any browser, in one file");
  const auto options = std::make_shared<WebArguments>();
  parser
      ->add_option("INPUT", options->words.input,
                   "Contours, mesh, lesson, or with --iso a volume; none: the sample molar")
      ->type_name("");
  parser->add_option("-o,--output", options->output, "The page to write")->required()->type_name("FILE.html");
  parser->add_option("--lesson", options->lesson, "A lesson to open with: a file, or a title of those built in")
      ->type_name("FILE");
  parser->add_option("--title", options->title, "What the page is called (default: the lesson's or the file's name)")
      ->type_name("TEXT");
  parser->add_option("--language", options->language, "Language: de, en, or a file of another (default: the browser's)")
      ->type_name("LANGUAGE");
  constexpr int most_budget = 1'000'000;
  parser->add_option("--budget", options->budget, "At most so many thousand bytes: DT's surfaces are simplified to fit")
      ->type_name("KB")
      ->check(whole_number_from_one_to(most_budget));
  parser->add_flag("--studio", options->studio,
                   "A page that makes models itself, of what is dropped on it in the browser");
  parser->add_flag("--db", options->words.with_db, "The DB method's model too, and a switch between both");
  constexpr int most_triangles = 100'000'000;
  parser->add_option("--triangles", options->words.triangles, "Simplify DT's surfaces to at most N triangles in all")
      ->type_name("N")
      ->check(whole_number_from_one_to(most_triangles));
  add_dt_options(*parser, options->words.dt);
  add_partition_options(*parser, options->words.dt.partition);
  add_volume_options(*parser, options->words.volume);
  add_db_options(*parser, options->words.db);
  add_volume_look_options(*parser, options->words.look);
  add_grey_option(*parser, options->words.grey);
  parser->footer(
      "Examples:\n"
      "  odontoscope web -o molar.html\n"
      "  odontoscope web canals.tour.json -o lesson.html\n"
      "  odontoscope web --lesson \"Find your way\" -o quiz.html\n"
      "  odontoscope web --lesson \"Find your way\" --language de -o quiz.html\n"
      "  odontoscope web molar.json -o molar.html --db --grid 64 --cases classic-unoriented\n"
      "  odontoscope web tooth.nrrd --iso 120 --min-area 4 --triangles 30000 -o tooth.html\n"
      "  odontoscope web tooth.nrrd --iso 120 --min-area 4 --triangles 30000 --show both -o ct.html\n"
      "  odontoscope web --studio -o studio.html\n"
      "\n"
      "The page opens from disk and asks the network for nothing: send it by mail, put it on a stick or a\n"
      "web server. Turn the tooth with mouse, fingers or keys, cut it open, fly through it; with a headset,\n"
      "take it into your hands. docs/web.md tells more.\n");
  return {parser, [options](Session& session) { return make_page(*options, session); }};
}

}  // namespace odontoscope::app
