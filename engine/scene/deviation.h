#pragma once
// Model against data: how far a surface lies from where the values that it was made from cross the same value, and how
// steeply they do.
//
// Values run trilinearly between the grid's places. Of each position the nearest crossing is looked for along straight
// lines: the surface's normal, the values' slope at the position and at the crossings found, and fourteen directions
// all around. What is found is never nearer than the nearest crossing is; where the values' own surface is bent no more
// sharply than a voxel it is that, nearly.

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/data_colours.h"
#include "engine/scene/model.h"
#include "engine/scene/value_grid.h"

namespace odontoscope {

/// Interpolated at a place in the user's coordinates, mm; beyond the outermost values as there.
double value_at(const ValueGrid& grid, const glm::dvec3& place_mm);

/// From the lower values to the higher, values a millimetre: differences over one step of the grid along each axis.
glm::dvec3 slope_at(const ValueGrid& grid, const glm::dvec3& place_mm);

/// How far crossings are looked for, in the grid's largest steps.
inline constexpr double deviation_reach_steps = 6;

/// The distance from `place` to where the values cross `iso`, mm, at most `deviation_reach_steps`; nothing beyond.
/// Positive where the value at `place` is below `iso`: there the model reaches beyond the data, since its surface lies
/// where the data have no material; negative where the data reach beyond the model. `normal`: of any length but 0.
std::optional<double> deviation_at(const ValueGrid& grid, double iso, const glm::dvec3& place_mm,
                                   const glm::dvec3& normal);

/// The value at which the surface of a solid was taken.
struct IsoOf {
  std::string solid;
  double iso = 0;
};

/// Fills in ModelPart::deviations of all parts of these solids; other parts have none. Contours have their points where
/// values cross, so that a surface made of them is off between slices above all: the parts' triangles are parted into
/// four before, at the middle of each edge, which changes no shape (ModelPart::indices are then not in the order of the
/// surface's triangles).
void mark_deviations(Model& model, const ValueGrid& grid, const std::vector<IsoOf>& isos);

/// Of all marked positions, each weighed as one.
struct DeviationSummary {
  std::size_t positions = 0, without = 0;  // that have a crossing in reach, and that have none
  double median_mm = 0, most_mm = 0;       // of the distances, whatever their sign
  double nineteen_of_twenty_mm = 0;        // are within
  glm::dvec3 most_at_mm{0};                // where, in the user's coordinates
  double usual_slope = 0;                  // values a millimetre: the median
  double steep_slope = 0;                  // nineteen of twenty are below
};
/// Nothing if no part is marked.
std::optional<DeviationSummary> deviations_in(const Model& model);

/// Colours that end at the grid's largest step, or where nineteen of twenty slopes are flatter.
DataColours usual_data_colours(DataColours::Of of, const DeviationSummary& found, const ValueGrid& grid);

}  // namespace odontoscope
