#include "recon/sample/tooth_number.h"

namespace odontoscope {

/// Clockwise as one looks at the patient's face: from the upper right third molar to the upper left one, then from the
/// lower left to the lower right.
int universal_number(const std::string& fdi) {
  if (fdi.size() != 2 || fdi[1] < '1' || fdi[1] > '8') return 0;
  const int place = fdi[1] - '0';
  switch (fdi[0]) {
    case '1':
      return 9 - place;
    case '2':
      return 8 + place;
    case '3':
      return 25 - place;
    case '4':
      return 24 + place;
    default:
      return 0;
  }
}

std::string tooth_in_words(ToothKind kind) {
  const SampleFacts facts = sample_facts(kind);
  const std::string name = facts.tooth.substr(0, facts.tooth.find(" (FDI"));
  return name + ": FDI " + facts.fdi + ", Universal " + std::to_string(universal_number(facts.fdi));
}

}  // namespace odontoscope
