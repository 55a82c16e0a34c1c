#pragma once
// For the first run: a strip of three hints, each ticked once done. All done, or closed, it never comes again
// (Settings::hints).

#include <glm/vec3.hpp>
#include <optional>

namespace odontoscope {

class Workspace;

class FirstHints {
 public:
  /// Once a frame. true: the last hint was followed just now.
  bool follow(Workspace& at);
  void draw(Workspace& at) const;

  bool turned() const { return turned_; }
  bool clicked() const { return clicked_; }
  bool flown() const { return flown_; }

 private:
  std::optional<glm::dvec3> first_view_;  // from where the model was seen first
  bool turned_ = false, clicked_ = false, flown_ = false;
};

}  // namespace odontoscope
