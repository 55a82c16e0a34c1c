// odontoscope_canal_family FIRST COUNT [SPACING [blended|delaunay [rare]]]: random roots with known canals, and how the
// anatomy of each was told, in tables. Exit code 1: fewer than 99 % counted right.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "tests/cavity/canal_family.h"

namespace {

using namespace odontoscope;

double part_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0
                        : values[std::min(values.size() - 1,
                                          static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

void print_table(const std::map<std::string, std::vector<test::FigureVerdict>>& figures) {
  fmt::print("{:<20} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "figure", "number", "bias %", "median %",
             "95th %", "worst %", "in 2 %", "in 3 %", "in 5 %", "in \u00b1");
  for (const auto& [name, all] : figures) {
    std::vector<double> errors;
    double bias = 0, covered = 0;
    for (const test::FigureVerdict& one : all) {
      errors.push_back(100 * std::abs(one.error()));
      bias += 100 * one.error() / static_cast<double>(all.size());
      covered += std::abs(one.told - one.known) <= one.off ? 100.0 / static_cast<double>(all.size()) : 0;
    }
    const auto within = [&](double bar) {
      return 100.0 *
             static_cast<double>(std::count_if(errors.begin(), errors.end(), [&](double e) { return e <= bar; })) /
             static_cast<double>(errors.size());
    };
    fmt::print("{:<20} {:>6} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f}\n", name,
               all.size(), bias, part_of(errors, 0.5), part_of(errors, 0.95), part_of(errors, 1), within(2), within(3),
               within(5), covered);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::puts("usage: odontoscope_canal_family FIRST COUNT [SPACING [blended|delaunay [rare]]]");
    return 2;
  }
  const auto first = std::strtoull(argv[1], nullptr, 10), count = std::strtoull(argv[2], nullptr, 10);
  const double spacing = argc > 3 ? std::atof(argv[3]) : 0.1;
  ReconstructOptions engine;
  engine.between =
      argc > 4 && std::string(argv[4]) == "delaunay" ? Between::delaunay : Between::blended;  // as the program does
  const bool rare = argc > 5 && std::string(argv[5]) == "rare";
  std::map<std::string, std::vector<test::FigureVerdict>> figures;
  std::vector<double> orifices;
  unsigned long long right = 0, beside = 0;
  for (auto seed = first; seed < first + count; ++seed) {
    const test::KnownRoot root = rare ? test::rare_root(seed) : test::random_root(seed);
    const test::FamilyVerdict verdict =
        test::judge(root, test::anatomy_of(reconstruct(test::slices_of(root, spacing), engine)));
    right += verdict.counted ? 1 : 0;
    beside += verdict.beside ? 1 : 0;
    if (!verdict.figures.empty()) orifices.push_back(verdict.orifice_off);
    std::string told =
        fmt::format("{} {}{}{}; orifice {:.2f} mm off;", seed, verdict.told, verdict.counted ? "" : " <-- WRONG",
                    verdict.beside ? "" : " <-- BESIDE", verdict.orifice_off);
    for (const test::FigureVerdict& one : verdict.figures) {
      figures[one.name].push_back(one);
      if (std::abs(one.error()) > (one.name == "length" ? 0.02 : 0.03) || std::abs(one.told - one.known) > one.off)
        told += fmt::format(" {} {:.3f} is {:.3f} \u00b1{:.3f};", one.name, one.told, one.known, one.off);
    }
    fmt::print("{}\n", told);
    std::fflush(stdout);
  }
  fmt::print(
      "{} roots, slices {} mm apart: canals and type {}, accessory canals and isthmuses {}; orifices off by {:.2f} mm "
      "(median), {:.2f} (95 of 100), {:.2f} (worst)\n",
      count, spacing, right, beside, part_of(orifices, 0.5), part_of(orifices, 0.95), part_of(orifices, 1));
  print_table(figures);
  return right * 100 >= count * 99 ? 0 : 1;
}
