#pragma once
// How coarse a volume's rays are in the headset, so that pictures keep up with its beat: whoever looks round must never
// wait for them.

namespace odontoscope {

class VolumePace {
 public:
  /// Steps of rays are so many times as long as in a picture of the desktop (GpuVolume::set_coarseness). 1 at first,
  /// `coarsest` at most.
  double coarseness() const { return coarseness_; }

  /// Drawing both eyes took so long, and there is a picture each `beat` seconds; nothing changes unless both are
  /// positive. What is too slow becomes coarser at once; finer only step by step, and not before half the time would
  /// do, so that it does not swing.
  void took(double drawing_seconds, double beat_seconds);

  static constexpr double coarsest = 6;

 private:
  double coarseness_ = 1;
};

}  // namespace odontoscope
