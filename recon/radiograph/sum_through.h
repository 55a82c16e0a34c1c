#pragma once
// The sum of a volume's values along each ray of a film, over its length.
//
// Values belong to the centres of voxels and are interpolated between them (trilinear); the volume ends where its
// outermost voxels do, half a spacing beyond their centres, over which their values stay the same. In each cell between
// eight centres the value along a ray is a polynomial of third degree, which Simpson's rule integrates without error:
// nothing is sampled, and no step is to be chosen.

#include "recon/core/progress.h"
#include "recon/radiograph/film.h"
#include "recon/volume/volume.h"

namespace odontoscope {

/// Sum of (value - `zero`) * mm at each pixel, 0 where a ray misses the volume. Precondition: `volume` passes
/// validate_volume. What lies behind the film's plane counts, what lies behind a cone's focus does not. Work is shared
/// among threads, the result does not depend on them. Stage "radiograph".
FilmMap sum_through(const Volume& volume, double zero, const FilmView& view, const Progress& progress = {});

/// Along one ray. Public for tests.
double sum_along(const Volume& volume, double zero, const FilmRay& ray);

}  // namespace odontoscope
