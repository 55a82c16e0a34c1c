#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/command.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "engine/app/volume_options.h"
#include "engine/app/words.h"
#include "engine/figures/draw.h"
#include "engine/figures/figures.h"
#include "engine/figures/figures_page.h"
#include "engine/gpu/context.h"
#include "engine/picture/png.h"

namespace odontoscope::app {
namespace {

namespace fs = std::filesystem;

constexpr int least_side = 64, most_side = 4096, least_grid = 16, most_grid = 512;

struct FiguresArguments {
  std::string input, folder;
  VolumeWords volume;
  std::vector<int> only;
  int size = 900, grid = static_cast<int>(figures::ToothOptions{}.grid);
  std::string backend = "auto";
};

std::vector<int> wanted_figures(const FiguresArguments& options) {
  std::vector<int> numbers = options.only;
  if (numbers.empty())
    for (const figures::Entry& entry : figures::paper_figures()) numbers.push_back(entry.number);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Refuses a folder that cannot be made or written to, before the work.
void refuse_unwritable_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error))
      throw FileError(folder.string(), "it is there, and is no folder", "Name another folder");
    refuse_unwritable({.inputs = {}, .outputs = {(folder / "index.html").string()}});
    return;
  }
  const fs::path parent = fs::absolute(folder).lexically_normal().parent_path();
  const fs::path above = folder.has_filename() ? parent : parent.parent_path();
  if (!fs::is_directory(above, error))
    throw FileError(folder.string(), "the folder above it does not exist", "Make that first");
  refuse_unwritable({.inputs = {}, .outputs = {(above / ".odontoscope-trial").string()}});
}

/// All files or none; a folder that was made for them goes again if they cannot be written.
void write_into(const fs::path& folder, const std::vector<FileContent>& files, Interrupts& interrupts) {
  std::error_code error;
  const bool fresh = fs::create_directory(folder, error);
  if (error) throw FileError(folder.string(), "the folder cannot be made: " + error.message(), "Name another folder");
  try {
    write_all(files, interrupts);
  } catch (...) {
    if (fresh) fs::remove(folder, error);
    throw;
  }
}

std::optional<ContourStack> contours_of(const FiguresArguments& options, Session& session) {
  if (options.input.empty()) {
    if (options.volume.any_level()) throw UsageError("--iso and --label want a volume", "Name it before the options");
    return std::nullopt;
  }
  refuse_volume_without_level(options.input, options.volume);
  return contours_of_input(options.input, options.volume, session);
}

std::string about(const figures::ToothModels& tooth) {
  return fmt::format("The tooth is {}; DB's grid has {} points along each side.",
                     tooth.name().empty() ? "yours" : tooth.name(), tooth.grid());
}

ExitCode make_figures(const FiguresArguments& options, Session& session) {
  const std::vector<int> numbers = wanted_figures(options);
  const ContextOptions context_options{.backend = backend_named(options.backend), .window_allowed = true};
  const fs::path folder = options.folder;
  refuse_unwritable_folder(folder);
  const std::unique_ptr<GlContext> context = make_context(context_options);

  figures::ToothModels tooth({contours_of(options, session), static_cast<std::size_t>(options.grid), session.threads},
                             session.progress());
  Renderer renderer(context->gl(), shaders_from_environment());
  std::vector<figures::Figure> made;
  std::vector<FileContent> files;
  for (const int number : numbers) {
    session.progress().check();
    session.progress().tell("figures", static_cast<double>(made.size()) / static_cast<double>(numbers.size()));
    figures::Figure figure = figures::make_figure(number, tooth);
    const std::vector<Image> images = figures::draw(context->gl(), renderer, figure, options.size);
    for (std::size_t i = 0; i < images.size(); ++i)
      files.push_back({folder / figures::picture_name(figure, i), png_bytes(images[i])});
    for (figures::Panel& panel : figure.panels) panel.surfaces.clear();  // the page needs the words only
    made.push_back(std::move(figure));
  }
  files.push_back({folder / "index.html", figures::index_page(made, about(tooth))});
  session.progress().check();
  write_into(folder, files, session.interrupts);
  session.console.say(fmt::format("Drawn with {}.", context->in_words()));
  session.console.say(fmt::format("Wrote {} in {} and {}", counted(files.size() - 1, "picture"),
                                  counted(made.size(), "figure"), (folder / "index.html").string()));
  return ExitCode::done;
}

}  // namespace

Command figures_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("figures", "The paper's figures, computed anew, as pictures and a page");
  const auto options = std::make_shared<FiguresArguments>();
  parser
      ->add_option("INPUT", options->input, "Contour stack, or with --iso or --label a volume; none: the sample molar")
      ->type_name("");
  parser->add_option("-o,--output", options->folder, "Folder for pictures and index.html; made if it is not there")
      ->required()
      ->type_name("DIR");
  repeatable(parser->add_option("--only", options->only, "This figure, 1 to 18; repeatable (default: all)"))
      ->type_name("N")
      ->check(whole_number_from_one_to(static_cast<int>(figures::paper_figures().size())));
  parser->add_option("--size", options->size, "Pixels along a picture's longer side, 64 to 4096")
      ->type_name("N")
      ->check(CLI::Range(least_side, most_side).description(""))
      ->capture_default_str();
  parser->add_option("--grid", options->grid, "Points along x and y of DB's grid for the tooth, 16 to 512")
      ->type_name("N")
      ->check(CLI::Range(least_grid, most_grid).description(""))
      ->capture_default_str();
  parser->add_option("--backend", options->backend, "auto, window, egl or osmesa; the last two need no display")
      ->type_name("NAME")
      ->capture_default_str();
  add_volume_options(*parser, options->volume);
  parser->footer(
      "Examples:\n"
      "  odontoscope figures -o figures\n"
      "  odontoscope figures tooth.nrrd --iso 120 --min-area 4 -o figures\n"
      "  odontoscope figures -o figures --only 9 --only 11 --size 1600\n"
      "\n"
      "Figures 1, 5, 6 and 15 to 17 show INPUT; the others small sets of contours and the sample molar.\n");
  return {parser, [options](Session& session) { return make_figures(*options, session); }};
}

}  // namespace odontoscope::app
