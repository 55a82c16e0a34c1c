#include "engine/scene/volume_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "assets/theme.h"
#include "recon/core/error.h"

namespace odontoscope {

std::optional<std::size_t> dental_film(const glm::dvec2& mm) {
  for (std::size_t i = 0; i < dental_films_mm.size(); ++i)
    if (mm == dental_films_mm[i] || mm == glm::dvec2(dental_films_mm[i].y, dental_films_mm[i].x)) return i;
  return std::nullopt;
}

namespace {

/// Where it lies between air (0) and dentine (1).
struct Anchored {
  double place;
  Colour colour;
  double extinction;
};

constexpr Colour dentine_colour = colour_of(assets::theme::volume::dentine),
                 enamel_colour = colour_of(assets::theme::volume::enamel),
                 pulp_colour = colour_of(assets::theme::volume::pulp),
                 soft_colour = colour_of(assets::theme::volume::soft);

std::vector<Anchored> anchored(TransferPreset preset) {
  switch (preset) {
    case TransferPreset::enamel:
      return {{1.1, enamel_colour, 0}, {1.25, enamel_colour, 4}, {1.5, enamel_colour, 30}};
    case TransferPreset::dentine:
      return {
          {0.4, dentine_colour, 0}, {0.7, dentine_colour, 20}, {1.15, dentine_colour, 30}, {1.35, enamel_colour, 40}};
    case TransferPreset::pulp:
      return {{0.25, pulp_colour, 0},   {0.45, pulp_colour, 2.5},  {0.65, pulp_colour, 0},
              {0.9, dentine_colour, 0}, {1, dentine_colour, 0.03}, {1.2, enamel_colour, 0.03}};
    case TransferPreset::soft:
      return {{0.12, soft_colour, 0}, {0.25, soft_colour, 3}, {0.4, soft_colour, 3}, {0.5, soft_colour, 0}};
    case TransferPreset::tooth:
      break;
  }
  return {{0.4, dentine_colour, 0},    {0.6, dentine_colour, 1.6}, {0.85, dentine_colour, 0.35},
          {1.1, dentine_colour, 0.35}, {1.3, enamel_colour, 1},    {1.6, enamel_colour, 3}};
}

}  // namespace

glm::vec4 transferred(const std::vector<TransferPoint>& transfer, double value) {
  if (transfer.empty()) return glm::vec4(0);
  const auto look = [](const TransferPoint& point) {
    return glm::vec4(linear(point.colour), static_cast<float>(point.extinction));
  };
  const auto above = std::upper_bound(transfer.begin(), transfer.end(), value,
                                      [](double wanted, const TransferPoint& point) { return wanted < point.value; });
  if (above == transfer.begin()) return look(transfer.front());
  if (above == transfer.end()) return look(transfer.back());
  const TransferPoint& below = *(above - 1);
  return glm::mix(look(below), look(*above), static_cast<float>((value - below.value) / (above->value - below.value)));
}

bool any_extinction(const std::vector<TransferPoint>& transfer, double low, double high) {
  if (transferred(transfer, low).a > 0 || transferred(transfer, high).a > 0) return true;
  return std::any_of(transfer.begin(), transfer.end(), [&](const TransferPoint& point) {
    return point.value > low && point.value < high && point.extinction > 0;
  });
}

bool sensible(const std::vector<TransferPoint>& transfer) {
  constexpr double most_value = 1e30;
  if (transfer.empty() || transfer.size() > most_transfer_points) return false;
  for (std::size_t i = 0; i < transfer.size(); ++i) {
    const TransferPoint& point = transfer[i];
    if (!(std::abs(point.value) <= most_value) || !(point.extinction >= 0 && point.extinction <= most_extinction))
      return false;
    if (i > 0 && !(transfer[i - 1].value < point.value)) return false;
  }
  return true;
}

bool Slopes::sensible() const {
  constexpr double steepest = 1e12;
  return (flat == 0 && steep == 0) || (flat >= 0 && flat < steep && steep <= steepest);
}

std::vector<TransferPoint> transfer_of(TransferPreset preset, double air, double dentine) {
  std::vector<TransferPoint> transfer;
  for (const Anchored& point : anchored(preset))
    transfer.push_back({air + point.place * (dentine - air), point.colour, point.extinction});
  return transfer;
}

}  // namespace odontoscope
