#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/image_verdict.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/piped_process.h"
#include "engine/app/shots.h"
#include "engine/app/words.h"
#include "engine/picture/compare_folders.h"
#include "engine/picture/png.h"
#include "recon/core/read_file.h"

namespace odontoscope::app {
namespace {

constexpr std::size_t most_png_bytes = std::size_t{1} << 30;

struct CompareImagesArguments {
  std::string a, b, difference, report, html;
  CompareFoldersOptions compared;
  ShotWords shots;
  bool accept = false;
};

bool is_folder(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_directory(name, error);
}

/// UsageError for what cannot be meant; FileError for what could not be written.
void refuse_senseless(const CompareImagesArguments& options, bool folders) {
  if (folders && !options.difference.empty())
    throw UsageError("--difference is about two pictures, and these are folders",
                     "Give --html, which shows every difference");
  if (!folders && is_folder(options.compared.mask))
    throw UsageError("--mask is a folder, and these are two pictures", "Give a PNG");
  if (is_folder(options.a) != is_folder(options.b))
    throw UsageError("one is a folder, and the other is none", "Give two folders of PNGs, or two PNGs");
  if (options.accept && !folders) throw UsageError("--accept is about two folders", "Copy a single picture yourself");
  if (options.accept && (!options.report.empty() || !options.html.empty() || !options.difference.empty()))
    throw UsageError("--accept compares nothing that --report, --html or --difference could tell", "Leave them out");
  PlannedFiles files;
  for (const auto& [file, ending] :
       {std::pair{options.difference, ".png"}, {options.report, ".json"}, {options.html, ".html"}}) {
    if (file.empty()) continue;
    known_ending(file, {ending});
    files.outputs.push_back(file);
  }
  if (!folders) files.inputs = {options.a, options.b};
  refuse_unwritable(files);
}

void tell_pictures(const std::vector<ComparedPicture>& pictures, const CompareImagesArguments& options, bool folders,
                   Console& console) {
  std::size_t alike = 0;
  for (const ComparedPicture& picture : pictures) {
    if (!folders) console.say(in_words(picture, options.compared.tolerance));
    if (picture.outcome == PictureOutcome::alike)
      ++alike;
    else if (folders)
      console.say(picture.name + ": " + in_words(picture, options.compared.tolerance));
  }
  if (folders) console.say(fmt::format("{} of {} alike", alike, counted(pictures.size(), "picture")));
}

std::string drawn_difference(const CompareImagesArguments& options) {
  std::optional<Image> mask;
  if (!options.compared.mask.empty()) mask = read_png(options.compared.mask);
  return png_bytes(difference_picture(read_png(options.a), read_png(options.b), mask ? &*mask : nullptr));
}

/// Of a picture, or 0 x 0: there is none.
std::pair<int, int> size_of(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {0, 0};
  const Image picture = read_png(file.string());
  return {picture.width, picture.height};
}

/// What came becomes what is expected: PNGs as they are, all else as it is drawn now.
ExitCode accept_pictures(const CompareImagesArguments& options, Session& session) {
  const std::filesystem::path to(options.a), from(options.b);
  std::vector<FileContent> contents;
  for (const std::string& name : pictures_below(options.b))
    contents.push_back({to / name, read_file((from / name).string(), most_png_bytes)});
  for (const std::string& name : options.compared.to_draw.names) {
    const auto [width, height] = size_of(to / name);
    contents.push_back({to / name, png_bytes(options.compared.to_draw.draw(name, width, height))});
  }
  session.progress().check();
  for (const FileContent& content : contents) std::filesystem::create_directories(content.file.parent_path());
  std::set<std::string> kept = pictures_below(options.a);
  write_all(contents, session.interrupts);
  session.console.say(fmt::format("{} expected from now on: look at them", counted(contents.size(), "picture")));
  for (const FileContent& content : contents) kept.erase(content.file.lexically_relative(to).generic_string());
  for (const std::string& name : kept)
    session.console.say(fmt::format("{} stays, and {} has nothing of its name: delete it if it is no longer wanted",
                                    (to / name).string(), options.b));
  return ExitCode::done;
}

/// The second of two files as a PNG, drawn if it is none.
std::string as_png(const CompareImagesArguments& options, Shots& shots, const OwnFolder& folder) {
  if (!shots.take(options.b)) return options.b;
  const PicturesToDraw drawn = shots.pictures();
  const auto [width, height] = size_of(options.a);
  const std::string& name = *drawn.names.begin();
  std::string file = (std::filesystem::path(folder.path()) / name).string();
  write_png(drawn.draw(name, width, height), file);
  return file;
}

ExitCode compare_images(const CompareImagesArguments& as_typed, Session& session) {
  CompareImagesArguments options = as_typed;
  const bool folders = is_folder(options.a) && is_folder(options.b);
  refuse_senseless(options, folders);
  Shots shots(options.shots, session);
  const OwnFolder drawn_here;
  const std::string second = options.b;
  if (folders) {
    shots.find(options.b, {options.report, options.html});
    options.compared.to_draw = shots.pictures();
    if (options.accept) return accept_pictures(options, session);
  } else {
    options.b = as_png(options, shots, drawn_here);
  }
  FailuresPage page(options.compared.tolerance);
  std::vector<FileContent> contents;
  const auto look = [&](const ComparedPicture& picture, const PicturesCompared& both) {
    if (!options.html.empty()) page.add(picture, both);
  };
  std::vector<ComparedPicture> pictures;
  if (folders)
    pictures = compare_folders(options.a, options.b, options.compared, look, session.progress());
  else
    pictures = {compare_files(options.a, options.b, options.compared, look)};
  if (pictures.empty())
    throw FileError(options.a, "holds no PNG, nor has the other folder a picture",
                    "A comparison of nothing proves nothing: check the names");
  if (!options.difference.empty() && pictures.front().difference.same_size)
    contents.push_back({options.difference, drawn_difference(options)});
  if (!options.report.empty())
    contents.push_back({options.report, image_verdict_text(options.a, second, options.compared.tolerance, pictures)});
  if (!options.html.empty()) contents.push_back({options.html, page.html(options.a, second, pictures)});
  session.progress().check();
  write_all(contents, session.interrupts);
  tell_pictures(pictures, options, folders, session.console);
  for (const ComparedPicture& picture : pictures)
    if (picture.outcome != PictureOutcome::alike) return ExitCode::found_wanting;
  return ExitCode::done;
}

}  // namespace

Command compare_images_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand(
      "compare-images", "Are two pictures, or two folders of them, the same within a tolerance? Exit code 1 if not");
  const auto options = std::make_shared<CompareImagesArguments>();
  ImageTolerance& tolerance = options->compared.tolerance;
  parser->add_option("A", options->a, "A PNG, or a folder of those expected")->required()->type_name("");
  parser->add_option("B", options->b, "What came: a PNG, GLB, scene or page, or their folder")
      ->required()
      ->type_name("");
  parser->add_option("--channel", tolerance.channel, "Difference of a channel that is none, of 255")
      ->type_name("N")
      ->check(CLI::Range(0, 255).description(""))
      ->capture_default_str();
  parser->add_option("--share", tolerance.share, "Share of pixels that may differ by more")
      ->type_name("F")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->capture_default_str();
  parser
      ->add_option("--similarity", tolerance.similarity,
                   "Least structural similarity, 1 for equal (default: not asked)")
      ->type_name("S")
      ->check(CLI::Range(-1.0, 1.0).description(""));
  parser->add_option("--mask", options->compared.mask, "Compare where it is light: a PNG, or a folder of them by name")
      ->type_name("PNG|DIR");
  parser->add_option("--difference", options->difference, "Draw where two PNGs differ")->type_name("FILE.png");
  parser->add_option("--report", options->report, "The verdict, for scripts")->type_name("FILE.json");
  parser->add_option("--html", options->html, "A page of what is not alike: expected, actual, difference")
      ->type_name("FILE.html");
  parser->add_option("--model", options->shots.model, "What scenes show that have no GLB of their name")
      ->type_name("FILE");
  parser
      ->add_option("--browser", options->shots.browser,
                   "For pages (default: $ODONTOSCOPE_BROWSER, or Chromium in PATH)")
      ->type_name("PROGRAM");
  parser->add_option("--timeout", options->shots.timeout_s, "Seconds for each that is drawn")
      ->type_name("S")
      ->check(CLI::Range(1.0, 3600.0).description(""))
      ->capture_default_str();
  parser->add_flag("--accept", options->accept, "Write what came into the folder of those expected; compare nothing");
  parser->footer(
      "Examples:\n"
      "  odontoscope compare-images before.png after.png\n"
      "  odontoscope compare-images a.png b.png --channel 0 --share 0 --difference where.png\n"
      "  odontoscope compare-images expected actual --report verdict.json --html failures.html\n"
      "  odontoscope compare-images expected actual --share 0 --similarity 0.99 --mask masks\n"
      "  odontoscope compare-images expected actual --model molar.json --accept\n"
      "\n"
      "In place of a PNG, B may hold a scene (.json), a .glb or a page (.html) of its name: it is drawn as large as\n"
      "what is expected, pages by a browser without the network.\n"
      "In folders a picture that is missing, unexpected or unreadable is a difference, too. docs/screenshot-tests.md\n"
      "shows tests of pictures in continuous integration.\n");
  return {parser, [options](Session& session) { return compare_images(*options, session); }};
}

}  // namespace odontoscope::app
