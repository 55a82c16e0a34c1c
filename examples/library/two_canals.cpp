// Contours made in code, reconstructed, and written as STL: a root whose one canal divides into two on its way down.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include "recon/delaunay/reconstruct.h"
#include "recon/output/model_file.h"

namespace {

odontoscope::Contour ellipse(odontoscope::Point2 centre, double half_width, double half_depth) {
  constexpr int corners = 48;
  odontoscope::Contour contour;  // of the structure "tooth", as long as nobody says otherwise
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / corners;
    contour.points.push_back({centre.x + half_width * std::cos(turn), centre.y + half_depth * std::sin(turn)});
  }
  return contour;
}

odontoscope::ContourStack root_with_dividing_canal() {
  odontoscope::ContourStack stack;
  for (int i = 0; i < 12; ++i) {
    const double z = 0.5 * i;
    odontoscope::Slice slice{z, {ellipse({0, 0}, 2.5 + 0.1 * z, 1.5 + 0.05 * z)}};
    const bool closed_below = i == 0, divided = i < 6;
    if (divided && !closed_below) {
      slice.contours.push_back(ellipse({-1.1, 0}, 0.5, 0.4));
      slice.contours.push_back(ellipse({1.1, 0}, 0.5, 0.4));
    } else if (!divided && i < 11) {
      slice.contours.push_back(ellipse({0, 0}, 1.7, 0.5));
    }
    stack.slices.push_back(slice);
  }
  return stack;
}

}  // namespace

int main(int argc, char** argv) try {
  const odontoscope::Reconstruction made = odontoscope::reconstruct(root_with_dividing_canal());
  for (const odontoscope::Shell& shell : made.solids.front().report.shells) {
    std::printf("%s of genus %ld, volume %.3f mm^3\n",
                shell.kind == odontoscope::Shell::Kind::cavity ? "cavity" : "external surface", shell.genus,
                shell.volume);
  }
  const std::vector<std::filesystem::path> files{argc > 1 ? argv[1] : "two_canals.stl"};
  odontoscope::write_model(made, files);
  return 0;
} catch (const odontoscope::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.exit_code());
}
