#include "recon/cavity/names.h"

#include <algorithm>
#include <limits>
#include <string>

#include "recon/cavity/limits.h"
#include "recon/sample/sample_tooth.h"

namespace odontoscope {
namespace {

/// For each place the line that ends nearest, if near enough and no line is taken twice; else nothing.
std::vector<CentreLine*> lines_to(std::vector<CentreLine>& lines, const std::vector<Point3>& places) {
  std::vector<CentreLine*> found;
  for (const Point3& place : places) {
    CentreLine* nearest = nullptr;
    double least = limits::known_end;
    for (CentreLine& line : lines) {
      if (const double far = length(line.end - place); far < least) {
        least = far;
        nearest = &line;
      }
    }
    if (nearest == nullptr || std::find(found.begin(), found.end(), nearest) != found.end()) return {};
    found.push_back(nearest);
  }
  return found;
}

std::string with_kind(const std::string& name, const char* kind) { return name.ends_with(kind) ? name : name + " " + kind; }

}  // namespace

void name_as_sample(CentreLines& lines) {
  for (const ToothKind kind : {ToothKind::molar, ToothKind::premolar, ToothKind::incisor}) {
    const SampleFacts facts = sample_facts(kind);
    if (facts.canals.size() != lines.canals.size()) continue;
    std::vector<Point3> ends;
    for (const CanalFact& canal : facts.canals) ends.push_back(canal.axis.front());
    const std::vector<CentreLine*> canals = lines_to(lines.canals, ends);
    if (canals.size() != ends.size()) continue;
    for (std::size_t i = 0; i < canals.size(); ++i) canals[i]->name = with_kind(facts.canals[i].name, "canal");
    for (const NamedPoint& horn : facts.horns)
      for (CentreLine* line : lines_to(lines.horns, {horn.at})) line->name = with_kind(horn.name, "horn");
    return;
  }
}

}  // namespace odontoscope
