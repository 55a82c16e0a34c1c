#include "engine/app/certificate_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>

#include "engine/app/words.h"

namespace odontoscope::app {
namespace {

constexpr std::size_t most_shells_told = 4;

/// "mm²" where the terminal's words say "mm^2".
std::string typeset(std::string words) {
  for (const auto& [plain, raised] : {std::pair{"^2", "\xC2\xB2"}, {"^3", "\xC2\xB3"}})
    for (std::size_t at = words.find(plain); at != std::string::npos; at = words.find(plain, at))
      words.replace(at, 2, raised);
  return words;
}

using Mark = Certificate::Mark;

Mark mark_of(bool good) { return good ? Mark::good : Mark::bad; }

void add_shells(const std::string& structure, const SurfaceReport& report, Certificate& certificate) {
  const std::vector<std::string> defects = defects_in_words(report);
  if (!defects.empty())
    certificate.findings.push_back({Mark::bad, fmt::format("{}: {}", structure, fmt::join(defects, ", "))});
  for (std::size_t i = 0; i < std::min(report.shells.size(), most_shells_told); ++i) {
    const Shell& shell = report.shells[i];
    certificate.findings.push_back({mark_of(defects.empty() && shell.kind != Shell::Kind::open),
                                    fmt::format("{}: {}", structure, typeset(shell_in_words(shell)))});
  }
  if (report.shells.size() > most_shells_told)
    certificate.findings.push_back(
        {mark_of(defects.empty()),
         fmt::format("{}: {} more", structure, counted(report.shells.size() - most_shells_told, "surface"))});
}

Certificate::Verdict verdict_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::green:
      return Certificate::Verdict::certified;
    case Verdict::amber:
      return Certificate::Verdict::look_here;
    case Verdict::red:
      break;
  }
  return Certificate::Verdict::wanting;
}

}  // namespace

Certificate certificate_of(const Proven& facts) {
  Certificate certificate{verdict_of(facts.verdict), facts.headline, {}};
  for (const Attention& item : facts.attention)
    certificate.findings.push_back(
        {Mark::look, typeset(in_words(item)), glm::dvec3(item.place.x, item.place.y, item.place.z)});
  if (facts.verdict != Verdict::red)
    certificate.findings.push_back({Mark::good, "Every surface is closed, manifold and faces outwards."});
  certificate.findings.push_back(
      {Mark::good, fmt::format("Every one of the {} has positive volume, and each face belongs to at most two.",
                               counted(facts.tetrahedra, "tetrahedron", "tetrahedra"))});
  certificate.findings.push_back(
      {Mark::good,
       fmt::format("Cut at each of the {}, the model is exactly the contours given.", counted(facts.slices, "slice"))});
  if (!facts.changes.empty()) certificate.findings.push_back({Mark::good, typeset(facts.changes) + "."});
  for (std::size_t i = 0; i < facts.reports.size(); ++i) add_shells(facts.structures[i], facts.reports[i], certificate);
  return certificate;
}

Certificate certificate_of(const std::vector<std::string>& structures, const std::vector<SurfaceReport>& reports) {
  Certificate certificate{Certificate::Verdict::sound, "Sound: closed, manifold, facing one way", {}};
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (!reports[i].closed_oriented_manifold()) certificate.verdict = Certificate::Verdict::wanting;
    add_shells(structures[i], reports[i], certificate);
  }
  if (certificate.verdict == Certificate::Verdict::wanting)
    certificate.headline = "Found wanting: not a closed oriented manifold";
  return certificate;
}

Certificate certificate_of(const std::vector<NamedSurface>& surfaces, const Progress& progress) {
  std::vector<std::string> structures;
  std::vector<SurfaceReport> reports;
  for (const NamedSurface& named : surfaces) {
    progress.check();
    structures.push_back(named.structure);
    reports.push_back(inspect(named.surface));
  }
  return certificate_of(structures, reports);
}

}  // namespace odontoscope::app
