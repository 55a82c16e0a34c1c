#pragma once
// Numbers and results in plain words.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recon/input/contour_stack.h"
#include "recon/mesh/surface_report.h"

namespace odontoscope::app {

/// "1 slice", "12,345 slices".
std::string counted(std::size_t count, std::string_view singular, std::string_view plural = {});

/// Three significant digits, without an exponent where a person would write none.
std::string measured(double value);

/// "155 slices from z = 0.125 to 20.4 mm, 812 contours, 48,754 points; structures: enamel, dentine, pulp".
std::string stack_in_words(const ContourStack& stack);

/// "external surface of genus 0, 12,345 triangles, volume 512 mm^3".
std::string shell_in_words(const Shell& shell);

/// What is wrong with a surface, each defect with its count; empty if it is a closed oriented manifold.
std::vector<std::string> defects_in_words(const SurfaceReport& report);

}  // namespace odontoscope::app
