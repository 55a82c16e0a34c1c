#include "recon/cavity/canal_names.h"

#include <algorithm>
#include <limits>
#include <string>

#include "recon/cavity/limits.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope {
namespace {

/// For each place the line that ends nearest, if near enough and no line is taken twice; else nothing.
template <class Lines>
auto lines_to(Lines& lines, const std::vector<Point3>& places) {
  std::vector<decltype(&lines[0])> found;
  for (const Point3& place : places) {
    decltype(&lines[0]) nearest = nullptr;
    double least = limits::known_end;
    for (auto& line : lines) {
      if (const double far = length(line.end - place); far < least) {
        least = far;
        nearest = &line;
      }
    }
    if (nearest == nullptr || std::find(found.begin(), found.end(), nearest) != found.end()) return decltype(found){};
    found.push_back(nearest);
  }
  return found;
}

std::vector<Point3> ends_of(const SampleFacts& facts) {
  std::vector<Point3> ends;
  for (const CanalFact& canal : facts.canals) ends.push_back(canal.axis.front());
  return ends;
}

std::string with_kind(const std::string& name, const char* kind) {
  return name.ends_with(kind) ? name : name + " " + kind;
}

}  // namespace

std::optional<ToothKind> sample_of(const CentreLines& lines) {
  for (const ToothKind kind : {ToothKind::molar, ToothKind::premolar, ToothKind::incisor}) {
    const SampleFacts facts = sample_facts(kind);
    if (facts.canals.size() == lines.canals.size() &&
        lines_to(lines.canals, ends_of(facts)).size() == facts.canals.size())
      return kind;
  }
  return std::nullopt;
}

void name_as_sample(CentreLines& lines) {
  const auto kind = sample_of(lines);
  if (!kind) return;
  const SampleFacts facts = sample_facts(*kind);
  const auto canals = lines_to(lines.canals, ends_of(facts));
  for (std::size_t i = 0; i < canals.size(); ++i) canals[i]->name = with_kind(facts.canals[i].name, "canal");
  for (const NamedPoint& horn : facts.horns)
    for (CentreLine* line : lines_to(lines.horns, {horn.at})) line->name = with_kind(horn.name, "horn");
}

}  // namespace odontoscope
