// odontoscope_canal_family FIRST COUNT [SPACING]: random roots with known canals, and how the anatomy of each was told. Exit code 1: fewer than 99 % right.

#include <cstdio>
#include <cstdlib>

#include "tests/cavity/canal_family.h"

int main(int argc, char** argv) {
  if (argc < 3) {
    std::puts("usage: odontoscope_canal_family FIRST COUNT [SPACING]");
    return 2;
  }
  const auto first = std::strtoull(argv[1], nullptr, 10), count = std::strtoull(argv[2], nullptr, 10);
  const double spacing = argc > 3 ? std::atof(argv[3]) : 0.1;
  unsigned long long right = 0, lengths = 0, widths = 0;
  for (auto seed = first; seed < first + count; ++seed) {
    const auto verdict = odontoscope::test::judge(odontoscope::test::random_root(seed), spacing);
    const bool length = verdict.counted && verdict.length_error < 0.02, width = verdict.counted && verdict.width_error < 0.03;
    right += verdict.counted ? 1 : 0;
    lengths += length ? 1 : 0;
    widths += width ? 1 : 0;
    std::printf("%llu %s: length %.2f %%, width %.2f %%%s\n", seed, verdict.told.c_str(), 100 * verdict.length_error, 100 * verdict.width_error,
                verdict.counted && length && width ? "" : "  <-- WRONG");
    std::fflush(stdout);
  }
  std::printf("%llu roots: canals and type %llu, lengths within 2 %% %llu, widths within 3 %% %llu\n", count, right, lengths, widths);
  return right * 100 >= count * 99 ? 0 : 1;
}
