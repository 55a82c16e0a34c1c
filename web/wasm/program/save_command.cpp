// Of the program in browsers alone: the model of the page that an instance made last, as files, without making it
// again. JavaScript holds it for as long as it keeps the instance.
#include <emscripten.h>

#include <memory>

#include "engine/app/made_model.h"
#include "engine/app/options.h"
#include "engine/app/outputs.h"
#include "recon/output/model_file.h"
#include "web/wasm/program/kept_model.h"

// clang-format off
EM_JS(void, odontoscope_keep, (odontoscope::app::MadeModel* model), { Module.keptModel = model; });
EM_JS(odontoscope::app::MadeModel*, odontoscope_kept, (), { return Module.keptModel || 0; });
// clang-format on

namespace odontoscope::app {
namespace {

struct SaveArguments {
  std::vector<std::string> outputs;
  std::string report;
  std::optional<std::string> elements;
};

/// Meshed anew, where elements are asked for.
std::unique_ptr<MadeModel> meshed(const MadeModel& kept, const std::string& size, Session& session) {
  const std::optional<double> wanted = element_size_from(size);
  if (!kept.model.simplifications.empty())
    throw UsageError("--elements and --triangles both make the surfaces anew", "Make the model without --triangles");
  auto made = std::make_unique<MadeModel>(kept);
  mesh_model(made->model, wanted, session.progress());
  return made;
}

ExitCode save(const SaveArguments& options, Session& session) {
  const MadeModel* kept = odontoscope_kept();
  if (kept == nullptr) throw UsageError("no model is kept here", "Make a page of contours or of a volume first");
  for (const std::string& output : options.outputs) known_ending(output, model_endings());
  if (!options.report.empty()) known_ending(options.report, {".json"});
  std::unique_ptr<MadeModel> own;
  if (options.elements) kept = (own = meshed(*kept, *options.elements, session)).get();
  std::vector<FileContent> files;
  for (const std::string& output : options.outputs) files.push_back(model_file(kept->model.reconstruction, output));
  if (!options.report.empty()) files.push_back({options.report, report_of(*kept)});
  write_all(files, session.interrupts);
  if (own) tell_model(own->model, 0, session.console);
  return ExitCode::done;
}

}  // namespace

void keep(MadeModel&& model) {
  delete odontoscope_kept();
  odontoscope_keep(new MadeModel(std::move(model)));
}

Command save_command(CLI::App& root) {
  CLI::App* parser = root.add_subcommand("save", "The model of the page that was made last, as files");
  const auto options = std::make_shared<SaveArguments>();
  repeatable(
      parser->add_option("-o,--output", options->outputs, "Model to write; its ending tells the format; repeatable"))
      ->type_name("FILE");
  parser->add_option("--report", options->report, "Certificate, counts, links and times")->type_name("FILE.json");
  parser
      ->add_option("--elements", options->elements,
                   "Mesh anew for simulation: edges of about MM, or quality: a size that fits")
      ->type_name("MM");
  return {parser, [options](Session& session) { return save(*options, session); }};
}

}  // namespace odontoscope::app
