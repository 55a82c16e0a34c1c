#pragma once
// What is said of a model's surface: on the viewer's panel, and on the page of `odontoscope web`.

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/ui/mark.h"

namespace odontoscope {

/// Is the surface what it should be? In words for a person.
struct Certificate {
  /// Proven with its solid, which is as its contours imply; proven, but some places want a look; closed, oriented and
  /// manifold; not even that.
  enum class Verdict { certified, look_here, sound, wanting };
  using Mark = odontoscope::Mark;
  struct Finding {
    Mark mark = Mark::good;
    std::string words;
    std::optional<glm::dvec3> at = {};  // mm: where to look
  };
  Verdict verdict = Verdict::wanting;
  std::string headline;
  std::vector<Finding> findings;
};

/// The sign that goes with a verdict.
inline Certificate::Mark mark_of(Certificate::Verdict verdict) {
  if (verdict == Certificate::Verdict::wanting) return Certificate::Mark::bad;
  return verdict == Certificate::Verdict::look_here ? Certificate::Mark::look : Certificate::Mark::good;
}

}  // namespace odontoscope
