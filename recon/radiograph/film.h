#pragma once
// A film, the tube that shines on it, and how dark it gets. All lengths in mm.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/core/geometry.h"

namespace odontoscope {

/// One number a pixel; rows from the top.
struct FilmMap {
  int width = 0, height = 0;
  std::vector<double> values;

  double& at(int column, int row) {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
  double at(int column, int row) const { return const_cast<FilmMap&>(*this).at(column, row); }
};

/// A flat film, and where the rays come from that meet its pixels' centres.
struct FilmView {
  enum class Beam { parallel, cone };

  Point3 centre;              // of the film
  Point3 right{1, 0, 0};      // of what is seen from the tube; unit length
  Point3 up{0, 0, 1};         // unit length, at right angles to `right`; right x up points to the tube's side
  int columns = 1, rows = 1;  // pixels
  double pixel = 1;           // side of a pixel
  Beam beam = Beam::parallel;
  Point3 towards_tube{0, -1, 0};  // of a parallel beam: unit length, to the tube's side of the film
  Point3 focus;                   // of a cone: where all rays begin, on the tube's side of the film

  Point3 towards_viewer() const;  // right x up
  Point3 pixel_centre(int column, int row) const;
};

/// A ray by its direction (unit length, from the tube to the film) and where it meets the film.
struct FilmRay {
  Point3 end, direction;
  double length = 0;  // from the focus to the film; infinite for a parallel beam
};
FilmRay ray_to(const FilmView& view, int column, int row);

/// What the film is laid over with: how much longer the exposure is, and the span of attenuations (natural logarithms
/// of what is swallowed) from the one that leaves it black to the one that leaves it white.
struct Exposure {
  double times = 1;  // of the usual one: more makes all darker
  double latitude = usual_latitude;
  bool inverted = false;  // dense is dark instead of white
  /// Film and sensors show two decades of light at once or nearly, ln 100 = 4.6; a molar takes 3 to 4 of it at 70 kV.
  static constexpr double usual_latitude = 4.0;
};

/// 0 black to 255 white, a pixel each; rows from the top. Precondition: times and latitude positive.
std::vector<std::uint8_t> greys(const FilmMap& attenuation, const Exposure& exposure);

}  // namespace odontoscope
