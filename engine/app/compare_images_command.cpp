#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/image_verdict.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/words.h"
#include "engine/picture/compare_folders.h"
#include "engine/picture/png.h"

namespace odontoscope::app {
namespace {

struct CompareImagesArguments {
  std::string a, b, difference, report, html;
  CompareFoldersOptions compared;
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

ExitCode compare_images(const CompareImagesArguments& options, Session& session) {
  const bool folders = is_folder(options.a) && is_folder(options.b);
  refuse_senseless(options, folders);
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
    throw FileError(options.a, "holds no PNG, nor does the other folder",
                    "A comparison of nothing proves nothing: check the names");
  if (!options.difference.empty() && pictures.front().difference.same_size)
    contents.push_back({options.difference, drawn_difference(options)});
  if (!options.report.empty())
    contents.push_back(
        {options.report, image_verdict_text(options.a, options.b, options.compared.tolerance, pictures)});
  if (!options.html.empty()) contents.push_back({options.html, page.html(options.a, options.b, pictures)});
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
      "compare-images", "Are two PNGs, or two folders of them, the same within a tolerance? Exit code 1 if not");
  const auto options = std::make_shared<CompareImagesArguments>();
  ImageTolerance& tolerance = options->compared.tolerance;
  parser->add_option("A", options->a, "A PNG, or a folder of those expected")->required()->type_name("");
  parser->add_option("B", options->b, "Another one, or the folder of those that came")->required()->type_name("");
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
  parser->footer(
      "Examples:\n"
      "  odontoscope compare-images before.png after.png\n"
      "  odontoscope compare-images a.png b.png --channel 0 --share 0 --difference where.png\n"
      "  odontoscope compare-images expected actual --report verdict.json --html failures.html\n"
      "  odontoscope compare-images expected actual --share 0 --similarity 0.99 --mask masks\n"
      "\n"
      "In folders a picture that is missing, unexpected or unreadable is a difference, too. docs/screenshot-tests.md\n"
      "shows tests of pictures in continuous integration.\n");
  return {parser, [options](Session& session) { return compare_images(*options, session); }};
}

}  // namespace odontoscope::app
