// Teeth with known truth, as many as are wanted: reconstructed, and held against it. docs/truth.md
//
//   odontoscope_truth family --seeds 1..1000 --every-spacing       topology alone, as the program's own default has it
//   odontoscope_truth family --seeds 1..20 --spacing 0.25 --tables  all methods, areas and distances, as Markdown
//   odontoscope_truth family --seeds 1..200 --labels --smooth 0.05
//   odontoscope_truth incisor FOLDER --tables
//   odontoscope_truth tooth --seed 7 --spacing 0.5 -o tooth.json    to look at one
//   odontoscope_truth mesh dentine=other.ply pulp=other2.ply --seed 7   somebody else's surfaces of it: JSON

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "recon/core/error.h"
#include "recon/formats/read_mesh.h"
#include "recon/input/stack_json.h"
#include "tooth_cuts.h"
#include "truth_tables.h"
#include "truths.h"

namespace odontoscope::test {
namespace {

struct Asked {
  std::string seeds = "1..20";
  std::uint64_t seed = 1;
  std::vector<double> spacings;
  bool every_spacing = false, labels = false, failing = false, tables = false, partition = false;
  std::optional<double> smooth;
  std::vector<std::string> meshes;  // "dentine=FILE"
  std::string folder = std::string(ODONTOSCOPE_DATA) + "/incisor_meshes", output;
  MeasureOptions measure;
  unsigned threads = 0;
};

const std::vector<double>& family_spacings() {
  static const std::vector<double> spacings{0.1, 0.2, 0.25, 0.35, 0.5};
  return spacings;
}

std::pair<std::uint64_t, std::uint64_t> seed_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  const std::uint64_t first = std::stoull(text.substr(0, dots));
  return {first, dots == std::string::npos ? first : std::stoull(text.substr(dots + 2))};
}

/// What comes of one seed, printed in the order of seeds whichever thread is done first.
class Output {
 public:
  Output(std::uint64_t first, const Asked& asked) : next_(first), asked_(asked) {}

  struct Line {
    double spacing = 0;
    Truth truth;
    Results results;
  };
  void take(std::uint64_t seed, const std::string& about, const std::string& tooth, std::vector<Line> lines) {
    std::string text = asked_.failing || about.empty() ? "" : about + "\n";
    for (const Line& line : lines) text += lines_of(tooth, line.spacing, line.truth, line.results, asked_.failing);
    const std::lock_guard lock(mutex_);
    for (const Line& line : lines) summary_.add(line.spacing, line.truth, line.results);
    waiting_[seed] = std::move(text);
    for (auto found = waiting_.find(next_); found != waiting_.end(); found = waiting_.find(++next_)) {
      std::fputs(found->second.c_str(), asked_.tables ? stderr : stdout);
      std::fflush(stdout);
      waiting_.erase(found);
    }
  }
  void print_summary() const { std::fputs((asked_.tables ? summary_.markdown() : summary_.text()).c_str(), stdout); }

 private:
  std::mutex mutex_;
  std::map<std::uint64_t, std::string> waiting_;
  std::uint64_t next_;
  const Asked& asked_;
  Summary summary_;
};

std::vector<double> spacings_for(std::uint64_t seed, const Asked& asked) {
  if (!asked.spacings.empty()) return asked.spacings;
  if (asked.every_spacing) return family_spacings();
  return {family_spacings()[seed % family_spacings().size()]};
}

ContourStack cut(const TurnedTooth& tooth, double spacing, const Asked& asked) {
  return asked.labels ? label_map_contours(tooth, spacing, asked.smooth) : contours_of(tooth, spacing);
}

void measure_tooth(std::uint64_t seed, const Asked& asked, Output& output) {
  TurnedTooth tooth(random_tooth(seed));
  if (asked.partition) tooth.choose(TurnedTooth::Walls::shared);
  TurnedTooth filled = tooth;
  filled.choose(TurnedTooth::Walls::filled);
  const std::string about = fmt::format("seed {}: {}", seed, tooth.tooth().in_words);
  const auto topology = counted_topology(tooth, usual_steps());
  if (!topology) {
    output.take(seed, about + ": truth too fine to count, left out", "", {});
    return;
  }
  const Truth truth = tooth_truth(tooth, *topology);
  std::vector<Output::Line> lines;
  for (const double spacing : spacings_for(seed, asked)) {
    const ContourStack stack = cut(tooth, spacing, asked);
    std::optional<ContourStack> shared;
    if (asked.partition) shared = asked.labels ? stack : cut(filled, spacing, asked);
    lines.push_back({spacing, truth, measure(stack, truth, asked.measure, shared ? &*shared : nullptr)});
  }
  output.take(seed, about, fmt::format("{:5}", seed), std::move(lines));
}

void run_family(const Asked& asked) {
  const auto [first, last] = seed_range(asked.seeds);
  Output output(first, asked);
  std::atomic<std::uint64_t> next{first};
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < asked.threads; ++i) {
      workers.emplace_back([&, end = last] {
        for (std::uint64_t seed = next++; seed <= end; seed = next++) measure_tooth(seed, asked, output);
      });
    }
  }
  output.print_summary();
}

void run_incisor(const Asked& asked) {
  const std::optional<RealTooth> tooth = incisor_meshes(asked.folder);
  if (!tooth)
    throw UsageError("the incisor's meshes are not in " + asked.folder, "Name the folder that has URI1_pulp.stl");
  const Truth truth = tooth->truth();
  const std::vector<double> spacings = asked.spacings.empty() ? std::vector{0.1, 0.25, 0.5} : asked.spacings;
  Output output(0, asked);
  for (std::size_t i = 0; i < spacings.size(); ++i)
    output.take(i, "", "incisor", {{spacings[i], truth, measure(tooth->contours(spacings[i]), truth, asked.measure)}});
  output.print_summary();
}

void write_tooth(const Asked& asked) {
  TurnedTooth tooth(random_tooth(asked.seed));
  if (asked.partition) tooth.choose(TurnedTooth::Walls::filled);
  const double spacing = asked.spacings.empty() ? 0.25 : asked.spacings.front();
  write_stack(cut(tooth, spacing, asked), asked.output);
  fmt::print("{}\n", tooth.tooth().in_words);
}

nlohmann::json told(const Topology& topology) { return {topology.pieces, topology.handles, topology.bubbles}; }

/// One line of JSON a mesh.
void hold_meshes(const Asked& asked) {
  const TurnedTooth tooth(random_tooth(asked.seed));
  const auto topology = counted_topology(tooth, usual_steps());
  if (!topology) throw UsageError("the tooth is too fine for its topology to be counted", "Choose another seed");
  const Truth truth = tooth_truth(tooth, *topology);
  for (const std::string& one : asked.meshes) {
    const std::size_t sign = one.find('=');
    const auto known = std::find(truth.names.begin(), truth.names.end(), one.substr(0, sign));
    if (sign == one.npos || known == truth.names.end())
      throw UsageError(one + " names no structure of the tooth", "Write dentine=FILE");
    const auto s = static_cast<std::size_t>(known - truth.names.begin());
    const SurfaceMesh surface = read_mesh(one.substr(sign + 1)).front().surface;
    const SurfaceReport report = inspect(surface);
    const MethodResult held = measure_surface(surface, report, truth, s);
    nlohmann::json line{{"structure", *known},
                        {"closed", report.closed_oriented_manifold()},
                        {"boundary_edges", report.boundary_edges},
                        {"nonmanifold_edges", report.nonmanifold_edges},
                        {"misoriented_edges", report.misoriented_edges},
                        {"degenerate_triangles", report.degenerate_triangles},
                        {"true", told(truth.topology[s])},
                        {"triangles", held.triangles},
                        {"found", nullptr},
                        {"mean", nullptr},
                        {"largest", nullptr}};
    if (held.topology) line["found"] = told(*held.topology);
    if (held.mean) line["mean"] = *held.mean;
    if (held.largest) line["largest"] = *held.largest;
    fmt::print("{}\n", line.dump());
  }
}

void add_cutting(CLI::App& command, Asked& asked) {
  command.add_option("--spacing", asked.spacings, "Distance of slices, mm (several may be given)");
  CLI::Option* labels =
      command.add_flag("--labels", asked.labels, "Contours of label maps, at dyadic and decimal voxels in turn");
  command.add_option("--smooth", asked.smooth, "Smooth the label maps' borders, by MM at most")->needs(labels);
}

void add_measuring(CLI::App& command, Asked& asked) {
  command.add_flag("--shape", asked.measure.shape, "Measure areas and distances between slices too");
  command.add_flag(
      "--partition", asked.partition,
      "Structures share their walls; beside DT of each the partition of all, of filled contours or of the label map");
  command.add_flag("--references", asked.measure.references, "DB and shape-based interpolation beside DT");
  command.add_flag("--tables", asked.tables,
                   "All methods and measures, as tables in Markdown; single teeth on the error output");
  command.add_flag("--failing", asked.failing, "Print only what DT has wrong though the slices tell of it");
  command.add_option("--threads", asked.threads, "Teeth at a time; all processors if not given");
  const std::map<std::string, Correspondence> criteria{{"reverse", Correspondence::reverse},
                                                       {"medial", Correspondence::medial},
                                                       {"overlap", Correspondence::overlap},
                                                       {"tracked", Correspondence::tracked}};
  command.add_option("--correspondence", asked.measure.engine.correspondence, "tracked, reverse, medial or overlap")
      ->transform(CLI::CheckedTransformer(criteria));
  const std::map<std::string, Between> ways{{"blended", Between::blended}, {"delaunay", Between::delaunay}};
  command
      .add_option("--between", asked.measure.ways, "blended or delaunay, or both; the program's default if not given")
      ->transform(CLI::CheckedTransformer(ways));
}

void settle(Asked& asked) {
  if (asked.threads == 0) asked.threads = std::max(1u, std::thread::hardware_concurrency());
  asked.measure.engine.threads = 1;
  if (!asked.tables) return;
  asked.measure.shape = asked.measure.references = true;
  asked.measure.ways = {Between::delaunay, Between::blended};
}

int run(int argc, char** argv) {
  Asked asked;
  CLI::App app("Teeth with known truth, reconstructed and held against it. Topology is pieces/handles/bubbles.");
  app.require_subcommand(1);
  CLI::App& family = *app.add_subcommand("family", "Teeth drawn at random from formulas");
  family.add_option("--seeds", asked.seeds, "A..B, one tooth each");
  family.add_flag("--every-spacing", asked.every_spacing,
                  "0.1, 0.2, 0.25, 0.35 and 0.5 mm for each tooth, not one in turn");
  CLI::App& incisor = *app.add_subcommand("incisor", "The meshes of a real incisor");
  incisor.add_option("FOLDER", asked.folder, "Where they lie");
  incisor.add_option("--spacing", asked.spacings, "Distance of slices, mm (several may be given)");
  CLI::App& tooth = *app.add_subcommand("tooth", "Writes one tooth's contours");
  tooth.add_option("--seed", asked.seed, "Which");
  tooth.add_flag("--filled", asked.partition, "Structures overlap those within them, for a partition");
  tooth.add_option("-o", asked.output, "A .json file")->required();
  CLI::App& mesh = *app.add_subcommand("mesh", "Holds surfaces that others made of a tooth against it");
  mesh.add_option("MESHES", asked.meshes, "structure=FILE, as read by `odontoscope check`")->required();
  mesh.add_option("--seed", asked.seed, "Which tooth");
  for (CLI::App* command : {&family, &tooth}) add_cutting(*command, asked);
  for (CLI::App* command : {&family, &incisor}) add_measuring(*command, asked);
  CLI11_PARSE(app, argc, argv);
  settle(asked);
  const auto start = std::chrono::steady_clock::now();
  if (mesh.parsed()) {
    hold_meshes(asked);
    return 0;
  }
  if (tooth.parsed()) {
    write_tooth(asked);
  } else if (family.parsed()) {
    run_family(asked);
  } else {
    run_incisor(asked);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  fmt::print("{:.0f} s on {} threads\n", took.count(), asked.threads);
  return 0;
}

}  // namespace
}  // namespace odontoscope::test

int main(int argc, char** argv) {
  try {
    return odontoscope::test::run(argc, argv);
  } catch (const odontoscope::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.exit_code());
  }
}
