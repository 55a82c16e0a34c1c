#pragma once
// Rays through volumes and surfaces in double precision on the processor, from the definitions: no bricks, no textures,
// no matrices. Millimetres.

#include <optional>
#include <vector>

#include "engine/gpu/framebuffer.h"
#include "engine/scene/scene.h"
#include "engine/scene/value_grid.h"
#include "recon/radiograph/film.h"

namespace odontoscope::test {

struct Ray {
  glm::dvec3 origin{0}, direction{0, 0, -1};  // unit length
  double begin = 0;                           // the eye; far before everything for a parallel camera
  glm::dvec3 at(double way) const { return origin + way * direction; }
};

/// Through the middle of a pixel, counted from the top left.
Ray ray_through(const Camera& camera, PixelSize size, int x, int y);

/// Interpolated between values, the same half a step beyond the outermost.
double value_at(const ValueGrid& grid, const glm::dvec3& place);

struct Span {
  double from = 0, to = 0;
  bool empty() const { return !(from < to); }
};
/// Where a ray runs within the grid's box and in what a section leaves.
Span span_of(const Ray& ray, const ValueGrid& grid, const std::optional<Section>& section);

/// Half the smallest distance of two values.
double stride_of(const ValueGrid& grid);

/// Premultiplied linear light, and how much of what is behind is covered.
struct Seen {
  glm::dvec3 light{0};
  double covered = 0;
};
Seen over(const Seen& before, const Seen& behind);

/// How steep the values are, in values a millimetre: by differences of places 0.6 values aside along each axis, at
/// every other corner of a box.
double slope_at(const ValueGrid& grid, const glm::dvec3& place);

/// Unlit emission and absorption between two places of a ray, by steps within which values run straight; `steps` to
/// each of stride_of. What look.slopes leave is by the slope in a step's middle.
Seen shaded(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole, double from, double to,
            double steps = 1);

/// Of the values' places in the window along all of the ray.
double largest(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole);
double average(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole);

/// Where the values first cross look.iso, by steps of a quarter of the stride.
std::optional<double> crossing(const ValueGrid& grid, const VolumeLook& look, const Ray& ray, const Span& whole);

/// The nearest triangle that a ray meets from its front, in what a section leaves.
std::optional<double> hit(const SurfaceMesh& mesh, const Ray& ray, const std::optional<Section>& section);

/// As a screen shows it, 0 to 255, and back. Exact, for light below the shoulder.
double encoded(double light);
double decoded(double shown);

}  // namespace odontoscope::test
