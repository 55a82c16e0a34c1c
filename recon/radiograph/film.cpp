#include "recon/radiograph/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/core/portable_math.h"
#include "recon/radiograph/film_vector.h"

namespace odontoscope {

using namespace radiograph;

Point3 FilmView::towards_viewer() const { return cross(right, up); }

Point3 FilmView::pixel_centre(int column, int row) const {
  const double x = pixel * (column + 0.5 - 0.5 * columns), y = pixel * (0.5 * rows - row - 0.5);
  return plus(centre, plus(times(x, right), times(y, up)));
}

FilmRay ray_to(const FilmView& view, int column, int row) {
  const Point3 end = view.pixel_centre(column, row);
  if (view.beam == FilmView::Beam::parallel)
    return {end, times(-1, view.towards_tube), std::numeric_limits<double>::infinity()};
  const Point3 way = minus(end, view.focus);
  const double far = length(way);
  return {end, times(1 / far, way), far};
}

std::vector<std::uint8_t> greys(const FilmMap& attenuation, const Exposure& exposure) {
  std::vector<std::uint8_t> shown;
  shown.reserve(attenuation.values.size());
  const double black = portable::log(exposure.times);
  for (const double value : attenuation.values) {
    const double part = std::clamp((value - black) / exposure.latitude, 0.0, 1.0);
    shown.push_back(static_cast<std::uint8_t>(std::lround(255 * (exposure.inverted ? 1 - part : part))));
  }
  return shown;
}

}  // namespace odontoscope
