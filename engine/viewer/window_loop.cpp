#include "engine/viewer/window_loop.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

namespace odontoscope {

void run_in_window(Viewer& viewer, Window& window, const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  constexpr double longest_step = 0.1;  // after a rest nothing jumps
  Clock::time_point before = Clock::now();
  std::string title;
  bool stop_heard = false;  // a request to stop counts once: then, as a closed window, it may be answered with no
  const auto to_close = [&] {
    const bool requested = stop.stop_requested(), fresh = requested && !std::exchange(stop_heard, requested);
    return window.closing() || fresh;
  };
  while (!(to_close() && viewer.may_close()) && !viewer.state().close && !viewer.state().headset_asked) {
    if (window.closing()) window.keep_open();  // something is asked first
    for (const Event& event : window.events(viewer.wait_timeout())) viewer.handle(event);
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - before).count();
    before = now;
    const PixelSize size = window.size();
    if (size.width < 1 || size.height < 1) continue;  // put away as an icon
    viewer.draw({size, window.scale(), std::min(seconds, longest_step)}, {0, 0, 0, size});
    window.show();
    window.set_pointer(viewer.pointer());
    if (std::string wanted = viewer.title(); wanted != title) window.set_title(title = std::move(wanted));
  }
  viewer.state().settings.window = window.outer_size();
}

}  // namespace odontoscope
