#include "recon/segmentation/segment_look.h"

#include <algorithm>
#include <cmath>

#include "recon/core/lower_case.h"
#include "recon/core/portable_math.h"

namespace odontoscope {
namespace {

constexpr Code anatomical{"123037004", "SCT", "Anatomical Structure"}, tooth{"38199008", "SCT", "Tooth"};

struct Known {
  std::string_view part;
  Code type;
  std::array<std::uint8_t, 3> colour;
};
constexpr std::array<Known, 6> known{{{"enamel", {"ENAMEL", "99ODONTO", "Enamel"}, {222, 235, 245}},
                                      {"dentin", {"DENTINE", "99ODONTO", "Dentine"}, {226, 190, 120}},
                                      {"pulp", {"PULP", "99ODONTO", "Dental pulp"}, {190, 45, 50}},
                                      {"cement", {"CEMENTUM", "99ODONTO", "Cementum"}, {180, 160, 110}},
                                      {"tooth", tooth, {235, 222, 190}},
                                      {"teeth", tooth, {235, 222, 190}}}};

/// Told apart by people who see few colours, too (M. Okabe and K. Ito's set).
constexpr std::array<std::array<std::uint8_t, 3>, 7> others{
    {{86, 180, 233}, {230, 159, 0}, {0, 158, 115}, {204, 121, 167}, {0, 114, 178}, {213, 94, 0}, {240, 228, 66}}};

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : portable::pow((c + 0.055) / 1.055, 2.4);
}

double lightness(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? portable::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

std::uint16_t in_16_bits(double part) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(part, 0.0, 1.0) * 65535));
}

}  // namespace

SegmentLook look_of(std::string_view name, std::size_t number) {
  const std::string small = lower_case(std::string(name));
  for (const Known& one : known) {
    if (small.find(one.part) == small.npos) continue;
    SegmentLook look{anatomical, one.type, {}, one.colour};
    if (one.type.value != tooth.value) look.region = tooth;
    return look;
  }
  return {anatomical, anatomical, {}, others[number % others.size()]};
}

std::array<std::uint16_t, 3> cie_lab(const std::array<std::uint8_t, 3>& colour) {
  const double r = linear(colour[0]), g = linear(colour[1]), b = linear(colour[2]);
  // sRGB to XYZ under D50 (IEC 61966-2-1 with Bradford's adaptation), over the white of D50.
  const double x = (0.4360747 * r + 0.3850649 * g + 0.1430804 * b) / 0.96422,
               y = 0.2225045 * r + 0.7168786 * g + 0.0606169 * b;
  const double z = (0.0139322 * r + 0.0971045 * g + 0.7141733 * b) / 0.82521;
  const double fx = lightness(x), fy = lightness(y), fz = lightness(z);
  return {in_16_bits((116 * fy - 16) / 100), in_16_bits((500 * (fx - fy) + 128) / 255),
          in_16_bits((200 * (fy - fz) + 128) / 255)};
}

}  // namespace odontoscope
