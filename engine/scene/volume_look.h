#pragma once
// How the grey values of a volume are shown, beside or instead of the surfaces that were made from them.

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "assets/films.h"
#include "assets/theme.h"
#include "engine/scene/colour.h"
#include "recon/core/named.h"

namespace odontoscope {

/// What material of this value looks like; between two points of a transfer function colour (in linear light) and
/// extinction run straight, beyond the outermost they stay.
struct TransferPoint {
  double value = 0;
  Colour colour;
  double extinction = 0;  // 1/mm: of light, exp(-extinction * mm) is let through
  friend bool operator==(const TransferPoint&, const TransferPoint&) = default;
};

/// How steep values are where something is seen of them, in values a millimetre: of `flat` ones and flatter nothing, of
/// `steep` ones and steeper all, in proportion between (Levoy, "Display of surfaces from volume data", IEEE CG&A 8(3),
/// 1988). So borders are seen and what lies between them is clear.
struct Slopes {
  double flat = 0, steep = 0;  // steep 0: all is seen, however flat
  bool count() const { return steep > 0; }
  bool sensible() const;
  friend bool operator==(const Slopes&, const Slopes&) = default;
};

/// Intraoral films by their size, upright: 0 and 1 for children and front teeth, 2 the usual one, 3 of bitewings, 4
/// occlusal.
inline constexpr auto dental_films_mm = [] {
  std::array<glm::dvec2, assets::films::intraoral_mm.size()> films{};
  for (std::size_t i = 0; i < films.size(); ++i)
    films[i] = {assets::films::intraoral_mm[i][0], assets::films::intraoral_mm[i][1]};
  return films;
}();
inline constexpr glm::dvec2 usual_film_mm = dental_films_mm[assets::films::usual];
/// The size of a film, upright or across; nothing: none of them.
std::optional<std::size_t> dental_film(const glm::dvec2& mm);

struct VolumeLook {
  enum class Shows { surfaces, volume, both };
  /// Shaded: emission and absorption after the transfer function. Maximum and average: along the ray, of the values'
  /// places in the window; radiograph: what is swallowed on the way, in proportion to the value from `black` on.
  /// Surface: where the values first cross `iso`.
  enum class Cast { shaded, maximum, average, radiograph, surface };
  Shows shows = Shows::surfaces;
  Cast cast = Cast::shaded;
  std::vector<TransferPoint> transfer;  // ascending
  Slopes slopes;                        // of a shaded volume; the extinction is less where values are flat
  bool lit = true;                      // by the values' slope, as if it were a surface
  double black = 0, white = 1;          // of maximum and average; air and dentine of a radiograph
  double attenuation = 0.25;            // 1/mm of value `white`, for a radiograph
  double latitude = 4;                  // attenuation that it shows white,
  bool inverted = false;                // or black
  glm::dvec2 film_mm{0};                // width and height of a film; 0: it has no edge
  double iso = 0;
  Colour iso_colour = colour_of(assets::theme::tissues::tooth);

  /// Greys, which have no depth: nothing else is shown with them.
  bool projects() const { return cast != Cast::shaded && cast != Cast::surface; }
  bool shows_volume() const { return shows != Shows::surfaces; }
  bool shows_surfaces() const { return shows == Shows::surfaces || (shows == Shows::both && !projects()); }
  friend bool operator==(const VolumeLook&, const VolumeLook&) = default;
};

inline constexpr NameTable<VolumeLook::Shows, 3> volume_shows{{{"surfaces", VolumeLook::Shows::surfaces},
                                                               {"volume", VolumeLook::Shows::volume},
                                                               {"both", VolumeLook::Shows::both}}};
inline constexpr NameTable<VolumeLook::Cast, 5> volume_casts{{{"shaded", VolumeLook::Cast::shaded},
                                                              {"maximum", VolumeLook::Cast::maximum},
                                                              {"average", VolumeLook::Cast::average},
                                                              {"radiograph", VolumeLook::Cast::radiograph},
                                                              {"surface", VolumeLook::Cast::surface}}};
inline const char* name(VolumeLook::Shows shows) { return word_of(volume_shows, shows); }
inline const char* name(VolumeLook::Cast cast) { return word_of(volume_casts, cast); }
/// Throw UsageError with the list of names.
inline VolumeLook::Shows shows_named(std::string_view name) {
  return value_named(volume_shows, name, "way to show a volume");
}
inline VolumeLook::Cast cast_named(std::string_view name) {
  return value_named(volume_casts, name, "way to cast rays");
}

/// Linear colour and extinction, 1/mm. Precondition: `transfer` is ascending; an empty one shows nothing.
glm::vec4 transferred(const std::vector<TransferPoint>& transfer, double value);

/// Does any value from `low` to `high` have an extinction?
bool any_extinction(const std::vector<TransferPoint>& transfer, double low, double high);

inline constexpr std::size_t most_transfer_points = 64;
inline constexpr double most_extinction = 1e4;

/// Ascending, finite, of a size that graphics processors reckon with, extinctions from 0 to most_extinction, at most
/// most_transfer_points.
bool sensible(const std::vector<TransferPoint>& transfer);

/// Ready-made transfer functions, laid out by the values that air and dentine have. Tooth: dentine clear enough to show
/// what is in it, enamel denser. Enamel: dentine only a breath. Dentine: all hard tissue. Pulp: the walls of what is
/// hollow, in red. Soft: what is a little denser than air.
enum class TransferPreset { tooth, enamel, dentine, pulp, soft };
inline constexpr NameTable<TransferPreset, 5> transfer_presets{{{"tooth", TransferPreset::tooth},
                                                                {"enamel", TransferPreset::enamel},
                                                                {"dentine", TransferPreset::dentine},
                                                                {"pulp", TransferPreset::pulp},
                                                                {"soft", TransferPreset::soft}}};
inline const char* name(TransferPreset preset) { return word_of(transfer_presets, preset); }
/// Throws UsageError with the list of names.
inline TransferPreset transfer_named(std::string_view name) {
  return value_named(transfer_presets, name, "transfer function");
}
std::vector<TransferPoint> transfer_of(TransferPreset preset, double air, double dentine);

}  // namespace odontoscope
