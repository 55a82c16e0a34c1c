#include <fmt/format.h>

#include <memory>
#include <string>

#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/picture/compare.h"
#include "engine/picture/png.h"

namespace odontoscope::app {
namespace {

struct CompareImagesArguments {
  std::string a, b, difference;
  ImageTolerance tolerance;
};

ExitCode compare_images(const CompareImagesArguments& options, Session& session) {
  if (!options.difference.empty()) {
    known_ending(options.difference, {".png"});
    refuse_unwritable({.inputs = {options.a, options.b}, .outputs = {options.difference}});
  }
  const Image a = read_png(options.a), b = read_png(options.b);
  const ImageDifference found = compare(a, b, options.tolerance);
  if (!found.same_size) {
    session.console.say(fmt::format("different: {} x {} and {} x {} pixels", a.width, a.height, b.width, b.height));
    return ExitCode::found_wanting;
  }
  if (!options.difference.empty()) write_all({{options.difference, png_bytes(difference_picture(a, b))}}, session.interrupts);
  session.console.say(fmt::format("{}: {} of {} pixels ({:.3f} %) differ by more than {} of 255, the most by {}; similarity {:.4f}",
                                  found.within_tolerance ? "alike" : "different", found.pixels,
                                  static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height), 100 * found.share,
                                  options.tolerance.channel, found.largest, found.similarity));
  return found.within_tolerance ? ExitCode::done : ExitCode::found_wanting;
}

}  // namespace

Command compare_images_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("compare-images", "Are two PNGs the same, within a tolerance? Exit code 1 if not");
  const auto options = std::make_shared<CompareImagesArguments>();
  parser->add_option("A", options->a, "A PNG")->required()->type_name("");
  parser->add_option("B", options->b, "Another one")->required()->type_name("");
  parser->add_option("--channel", options->tolerance.channel, "Difference of a channel that is none, of 255")
      ->type_name("N")
      ->check(CLI::Range(0, 255).description(""))
      ->capture_default_str();
  parser->add_option("--share", options->tolerance.share, "Share of pixels that may differ by more")
      ->type_name("F")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->capture_default_str();
  parser->add_option("--difference", options->difference, "Draw where they differ")->type_name("FILE.png");
  parser->footer(
      "Examples:\n"
      "  odontoscope compare-images before.png after.png\n"
      "  odontoscope compare-images a.png b.png --channel 0 --share 0 --difference where.png\n");
  return {parser, [options](Session& session) { return compare_images(*options, session); }};
}

}  // namespace odontoscope::app
