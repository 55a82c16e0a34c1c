// Teeth with known truth, as many as are wanted: reconstructed, and held against it.
//
//   odontoscope_truth family --seeds 1..1000
//   odontoscope_truth family --seeds 1..20 --spacing 0.25 --shape --references
//   odontoscope_truth incisor --shape --references

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>

#include "recon/core/error.h"
#include "tooth_cuts.h"
#include "truth_tables.h"
#include "truths.h"

namespace odontoscope::test {
namespace {

struct Asked {
  std::string seeds = "1..20";
  std::vector<double> spacings;
  bool every_spacing = false, labels = false, failing = false, references = false;
  std::string write;
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
  Output(std::uint64_t first, bool failing_only) : next_(first), failing_only_(failing_only) {}

  struct Line {
    double spacing = 0;
    Truth truth;
    Results results;
  };
  void take(std::uint64_t seed, const std::string& about, const std::string& tooth, std::vector<Line> lines) {
    std::string text = failing_only_ || about.empty() ? "" : about + "\n";
    for (const Line& line : lines) text += lines_of(tooth, line.spacing, line.truth, line.results, failing_only_);
    const std::lock_guard lock(mutex_);
    for (const Line& line : lines) summary_.add(line.spacing, line.truth, line.results);
    waiting_[seed] = std::move(text);
    for (auto found = waiting_.find(next_); found != waiting_.end(); found = waiting_.find(++next_)) {
      std::fputs(found->second.c_str(), stdout);
      std::fflush(stdout);
      waiting_.erase(found);
    }
  }
  std::string summary() const { return summary_.text(); }

 private:
  std::mutex mutex_;
  std::map<std::uint64_t, std::string> waiting_;
  std::uint64_t next_;
  bool failing_only_;
  Summary summary_;
};

std::vector<double> spacings_for(std::uint64_t seed, const Asked& asked) {
  if (!asked.spacings.empty()) return asked.spacings;
  if (asked.every_spacing) return family_spacings();
  return {family_spacings()[seed % family_spacings().size()]};
}

void measure_tooth(std::uint64_t seed, const Asked& asked, Output& output) {
  const TurnedTooth tooth(random_tooth(seed));
  const std::string about = fmt::format("seed {}: {}", seed, tooth.tooth().in_words);
  const auto topology = counted_topology(tooth, usual_steps());
  if (!topology) {
    output.take(seed, about + ": truth too fine to count, left out", "", {});
    return;
  }
  const Truth truth = tooth_truth(tooth, *topology);
  std::vector<Output::Line> lines;
  for (const double spacing : spacings_for(seed, asked)) {
    const ContourStack stack = asked.labels ? label_map_contours(tooth, spacing) : contours_of(tooth, spacing);
    lines.push_back({spacing, truth, measure(stack, truth, asked.measure)});
  }
  output.take(seed, about, fmt::format("{:5}", seed), std::move(lines));
}

void run_family(const Asked& asked) {
  const auto [first, last] = seed_range(asked.seeds);
  Output output(first, asked.failing);
  std::atomic<std::uint64_t> next{first};
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < asked.threads; ++i) {
      workers.emplace_back([&, end = last] {
        for (std::uint64_t seed = next++; seed <= end; seed = next++) measure_tooth(seed, asked, output);
      });
    }
  }
  std::fputs(output.summary().c_str(), stdout);
}

void run_incisor(const Asked& asked) {
  const std::optional<RealTooth> tooth = incisor_meshes();
  if (!tooth) throw UsageError("the incisor's meshes are not there", "set the CMake variable ODONTOSCOPE_DATA");
  const Truth truth = tooth->truth();
  const std::vector<double> spacings = asked.spacings.empty() ? std::vector{0.1, 0.25, 0.5} : asked.spacings;
  Output output(0, asked.failing);
  for (std::size_t i = 0; i < spacings.size(); ++i)
    output.take(i, "", "incisor", {{spacings[i], truth, measure(tooth->contours(spacings[i]), truth, asked.measure)}});
  std::fputs(output.summary().c_str(), stdout);
}

void add_options(CLI::App& command, Asked& asked) {
  command.add_option("--spacing", asked.spacings, "Distance of slices, mm (several may be given)");
  command.add_flag("--shape", asked.measure.shape, "Measure areas and distances between slices too");
  command.add_flag("--references", asked.measure.references, "Shape-based interpolation and DB beside DT");
  command.add_flag("--failing", asked.failing, "Print only what DT has wrong");
  command.add_option("--threads", asked.threads, "Teeth at a time; all processors if not given");
  const std::map<std::string, Correspondence> criteria{
      {"reverse", Correspondence::reverse}, {"medial", Correspondence::medial}, {"overlap", Correspondence::overlap},
      {"tracked", Correspondence::tracked}};
  command.add_option("--correspondence", asked.measure.engine.correspondence, "tracked, reverse, medial or overlap")
      ->transform(CLI::CheckedTransformer(criteria));
  const std::map<std::string, Between> ways{{"blended", Between::blended}, {"delaunay", Between::delaunay}};
  command.add_option("--between", asked.measure.engine.between, "blended or delaunay")->transform(CLI::CheckedTransformer(ways));
}

int run(int argc, char** argv) {
  Asked asked;
  CLI::App app("Teeth with known truth, reconstructed and held against it. Topology is pieces/handles/bubbles.");
  app.require_subcommand(1);
  CLI::App& family = *app.add_subcommand("family", "Teeth drawn at random from formulas");
  family.add_option("--seeds", asked.seeds, "A..B, one tooth each");
  family.add_flag("--every-spacing", asked.every_spacing, "0.1, 0.2, 0.25, 0.35 and 0.5 mm for each tooth, not one in turn");
  family.add_flag("--labels", asked.labels, "Contours of label maps, at dyadic and decimal voxels in turn");
  CLI::App& incisor = *app.add_subcommand("incisor", "The meshes of a real incisor");
  for (CLI::App* command : {&family, &incisor}) add_options(*command, asked);
  CLI11_PARSE(app, argc, argv);
  if (asked.threads == 0) asked.threads = std::max(1u, std::thread::hardware_concurrency());
  asked.measure.engine.threads = 1;
  const auto start = std::chrono::steady_clock::now();
  family.parsed() ? run_family(asked) : run_incisor(asked);
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
