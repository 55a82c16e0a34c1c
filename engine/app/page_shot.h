#pragma once
// Web pages as pictures: a browser of the Chromium family that is installed here draws them, without a window and
// without the network.
//
// A page says that it has drawn by an attribute of its root element: <html data-drawn>; that it cannot by data-failed,
// with the reason. Pages that `odontoscope web` wrote do, once nothing is left to be made finer.

#include <memory>
#include <string>

#include "engine/picture/image.h"
#include "recon/core/progress.h"

namespace odontoscope::app {

/// What was asked for, else what ODONTOSCOPE_BROWSER names, else the first of chromium, google-chrome and their likes
/// in PATH. Throws GraphicsError no-browser.
std::string browser_program(const std::string& asked);

class PageShots {
 public:
  /// Starts the browser. Throws FileError if it does not start, InputError cannot-be-shot if it does not answer.
  PageShots(const std::string& program, double timeout_s, const Progress& progress);
  ~PageShots();

  /// A page from disk as it stands once it has drawn, at one pixel a pixel, in dark colours, with nothing moving that
  /// need not. Throws InputError cannot-be-shot, naming the page: it cannot be opened, says that it failed, or has not
  /// drawn in time; Cancelled.
  Image shoot(const std::string& page, int width, int height);

 private:
  class Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace odontoscope::app
