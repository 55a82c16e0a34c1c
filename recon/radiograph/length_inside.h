#pragma once
// How far each ray of a film runs inside a solid, from the solid's surface alone.
//
// A ray enters the material where it meets a face from its front and leaves it where it meets one from behind: the sum
// of the depths of the latter less those of the former is the length inside, whatever the order (and once for each time
// that the surface goes round a place).
//
// Every triangle is projected onto the film, its corners rounded to a fraction of a pixel once for all triangles that
// share them, and covered pixel by pixel with whole numbers: which pixels' centres a triangle holds is exact, and one
// on an edge belongs to one of the two triangles (the rule of rasterisers, left and top edges). So over a closed
// surface as many faces turn to the tube as away from it at every pixel, and no ray leaks. What is rounded is the place
// of a silhouette, by less than a pixel over 2^8 at worst and 2^16 usually.

#include <span>

#include "recon/core/progress.h"
#include "recon/mesh/meshes.h"
#include "recon/radiograph/film.h"

namespace odontoscope {

/// mm at each pixel. `surfaces` together bound the solid, wound counter-clockwise seen from outside the material,
/// cavities included. What the film's plane cuts off counts in full. Work is shared among threads, the result does not
/// depend on them. Throws UsageError if a cone's focus does not lie before all of the solid, or the solid spans over
/// 2^20 pixels.
FilmMap length_inside(std::span<const SurfaceMesh* const> surfaces, const FilmView& view,
                      const Progress& progress = {});

}  // namespace odontoscope
