#pragma once
// The sheet that everything written in the headset's room is drawn on, once for both eyes: the panel at its upper left,
// labels below. A hand's ray is its mouse.

#include <vector>

#include "engine/headset/billboard_pass.h"
#include "engine/headset/billboards.h"
#include "engine/headset_viewer/headset_panel.h"
#include "engine/ui/interface.h"
#include "engine/ui/interface_pass.h"

namespace odontoscope {

class HeadsetTexture {
 public:
  /// The context of `gl` is current now and at every call, and outlives this. Throws GraphicsError.
  HeadsetTexture(const Gl& gl, const ShaderLibrary& shaders, HeadsetPage page = HeadsetPage::tooth);

  /// Takes what the hands do on the panel into `visit`, and draws the sheet if something on it may have changed.
  void update(Visit& visit, const HeadsetInput& input, const VisitWorld& world, const HeadsetPanelWords& words,
              double seconds);
  /// The panel, the labels and the rays that meet the panel, over what an eye sees.
  void draw(const EyeView& eye, const Target& target) const;

  const Interface& interface() const { return interface_; }
  /// Where a pixel of the sheet is on the panel, as PanelPlace counts.
  static glm::dvec2 on_panel(double x, double y);
  const Framebuffer& pixels() const { return texture_; }

 private:
  void feed(const Visit& visit, const HeadsetInput& input, double seconds);
  void write(const std::vector<Billboard>& billboards, const Pose& head);
  void place(const Visit& visit, const HeadsetInput& input);

  const Gl* gl_;
  Interface interface_;
  InterfacePass interface_pass_;
  BillboardPass billboard_pass_;
  Framebuffer texture_;
  HeadsetPage page_;
  bool down_ = false;                 // the mouse's button, as it was fed
  double waited_ = 1e9;               // seconds since the sheet was drawn
  std::vector<std::string> written_;  // on it: the labels
  std::vector<SheetPiece> pieces_, labels_;
  std::vector<Beam> beams_;
  double light_ = 1;  // less during a fade
};

}  // namespace odontoscope
