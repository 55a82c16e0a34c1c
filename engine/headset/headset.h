#pragma once
// A headset through OpenXR: frames in, pictures out. No type of OpenXR is seen here, so that the program builds without
// it, too.
//
// The runtime owns the clock: `frame` waits for its beat. Everything happens on the thread that opened the headset,
// with the context current that was current then. Lengths are metres of the room.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/gpu/gl.h"
#include "engine/gpu/graphics_error.h"
#include "engine/headset/hands.h"
#include "engine/render/resolve_pass.h"

namespace odontoscope {

/// No headset can be used, or not any more. `cause` is one of headset-not-built, no-openxr-runtime,
/// openxr-service-absent, no-headset, headset-graphics, headset-lost, openxr-failed.
class HeadsetError : public GraphicsError {
 public:
  using GraphicsError::GraphicsError;
};

struct HeadsetOptions {
  /// Names of API layers to switch on, for tests: XR_APILAYER_LUNARG_core_validation.
  std::vector<std::string> layers = {};
  /// Of what the runtime recommends, along each side of the eyes' pictures: less than 1 for slow machines.
  double resolution = 1;
};

/// waiting: the runtime does not want pictures yet, or not now. over: it asked us to end.
enum class HeadsetState { waiting, running, visible, focused, over };

/// What depths 0 and 1 of an eye's picture mean: metres of the room ahead of the eye.
struct DepthRange {
  double nearest = 0, farthest = 0;
};
/// An eye each; empty: the depths are worth nothing.
using Depths = std::vector<DepthRange>;

/// What the lenses of an eye hide of its picture: triangles in tangents from the line of sight.
using HiddenCorners = std::vector<glm::vec2>;

struct HeadsetFrame {
  bool draw = false;            // false: nobody would see it, and there are no targets
  double seconds = 0;           // since the frame before, by the times at which they are shown
  double beat = 0;              // seconds from a picture to the next where none is missed; 0: the runtime does not say
  std::vector<EyeView> eyes;    // left, right
  std::vector<Target> targets;  // one an eye, with depth, which is kept
  std::vector<const HiddenCorners*> hidden;  // one an eye, or none at all; valid during the frame
  HeadsetInput input;
};

class Headset {
 public:
  virtual ~Headset() = default;
  Headset(const Headset&) = delete;
  Headset& operator=(const Headset&) = delete;

  /// Takes what the runtime reports. Throws HeadsetError "headset-lost" if there is no runtime any more.
  virtual HeadsetState poll() = 0;
  /// Precondition: running, visible or focused. Waits for the runtime's beat and calls `draw`, which draws into the
  /// targets and says what their depths mean, or throws; the frame is ended either way. Throws as `poll` does.
  using Draw = std::function<Depths(const HeadsetFrame&)>;
  virtual void frame(const Draw& draw) = 0;
  /// Asks the runtime to end; `poll` will say `over` then.
  virtual void leave() = 0;

  /// Lets a hand (0 left, 1 right) feel something of that strength, 0 to 1, if its controller can. Nothing without
  /// focus.
  virtual void pulse(std::size_t hand, double strength, double seconds) = 0;

  /// "Monado 25.0.0, Remote HMD, 1024 x 1024 an eye, RGBA8 sRGB through Xlib".
  virtual const std::string& in_words() const = 0;
  /// What is in the hands, as far as the runtime says.
  virtual std::string controllers() const = 0;

 protected:
  Headset() = default;
};

/// Was the program built with OpenXR?
bool headsets_built_in();

/// Finds the headset and opens a session on it for the context that is current. Throws HeadsetError.
std::unique_ptr<Headset> open_headset(const Gl& gl, const HeadsetOptions& options = {});

}  // namespace odontoscope
