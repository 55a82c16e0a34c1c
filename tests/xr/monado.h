#pragma once
// Monado, an OpenXR runtime, as a test starts and stops it: no headset, no graphics card. Only inside the root of
// tests/xr/run_in_root.

#include <sys/types.h>

#include <string>
#include <vector>

#include "engine/headset/hands.h"

namespace odontoscope::testing_support {

/// What Monado's remote devices (a head and two Index controllers) shall say.
struct RemoteBody {
  Pose head{{0, 1.6, 0}, {1, 0, 0, 0}};
  struct Hand {
    bool there = true;
    Pose pose{{0, 1.3, -0.3}, {1, 0, 0, 0}};
    double trigger = 0, squeeze = 0;
    glm::dvec2 stick{0};
    bool b = false;  // the upper button
  };
  Hand left{.pose = {{-0.2, 1.3, -0.3}, {1, 0, 0, 0}}}, right{.pose = {{0.2, 1.3, -0.3}, {1, 0, 0, 0}}};
};

class Monado {
 public:
  /// Starts the service and waits until it answers. `words`: its environment besides, "NAME=value".
  explicit Monado(const std::vector<std::string>& words = {});
  /// Stops it, if it runs, and waits for its end.
  ~Monado();
  Monado(const Monado&) = delete;
  Monado& operator=(const Monado&) = delete;

  /// As when it crashes.
  void kill();
  /// The devices say so from now on; what the runtime makes of it is seen a moment later.
  void say(const RemoteBody& body);
  /// All that it has written.
  static std::string log();

 private:
  pid_t service_ = -1;
  int devices_ = -1;  // a socket
  int keeps_input_ = -1;
};

}  // namespace odontoscope::testing_support
