#include "recon/radiograph/tissue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/core/portable_math.h"

namespace odontoscope {

namespace {

constexpr std::array<double, 9> table_kev{10, 15, 20, 30, 40, 50, 60, 80, 100};

/// cm^2/g, a row an element.
constexpr std::array<std::array<double, table_kev.size()>, element_count> table{{
    {0.3854, 0.3764, 0.3695, 0.3570, 0.3458, 0.3355, 0.3260, 0.3091, 0.2944},
    {2.373, 0.8071, 0.4420, 0.2562, 0.2076, 0.1871, 0.1753, 0.1610, 0.1514},
    {3.879, 1.236, 0.6178, 0.3066, 0.2288, 0.1980, 0.1817, 0.1639, 0.1529},
    {5.952, 1.836, 0.8651, 0.3779, 0.2585, 0.2132, 0.1907, 0.1678, 0.1551},
    {40.35, 12.39, 5.352, 1.700, 0.8096, 0.4916, 0.3494, 0.2324, 0.1865},
    {50.12, 15.50, 6.708, 2.113, 0.9872, 0.5849, 0.4053, 0.2585, 0.2020},
    {93.41, 29.79, 13.06, 4.080, 1.830, 1.019, 0.6578, 0.3656, 0.2571},
}};

using Shares = std::array<double, element_count>;  // H, C, N, O, P, S, Ca

/// By the weights of the atoms in Ca10(PO4)6(OH)2.
constexpr Shares hydroxyapatite{0.0020, 0, 0, 0.4141, 0.1850, 0, 0.3989};
constexpr Shares water{0.1119, 0, 0, 0.8881, 0, 0, 0};
constexpr Shares protein{0.066, 0.534, 0.170, 0.220,
                         0,     0.010, 0};  // Woodard and White, British Journal of Radiology 59, 1986

Shares mixed(double mineral, double organic, double wet) {
  Shares shares{};
  for (std::size_t i = 0; i < element_count; ++i)
    shares[i] = mineral * hydroxyapatite[i] + organic * protein[i] + wet * water[i];
  return shares;
}

Shares whole(Shares shares) {
  double sum = 0;
  for (const double share : shares) sum += share;
  for (double& share : shares) share /= sum;
  return shares;
}

}  // namespace

const std::vector<Tissue>& known_tissues() {
  static const std::vector<Tissue> tissues{
      {"enamel", 2.95, whole(mixed(0.96, 0.01, 0.03))},
      {"dentine", 2.14, whole(mixed(0.70, 0.20, 0.10))},
      {"pulp", 1.06, whole({0.102, 0.143, 0.034, 0.710, 0.003, 0.005, 0.003})},
      {"cementum", 1.92, whole({0.034, 0.155, 0.042, 0.438, 0.103, 0.003, 0.225})},
      {"bone", 1.92, whole({0.034, 0.155, 0.042, 0.438, 0.103, 0.003, 0.225})},
      {"water", 1.00, whole(water)},
  };
  return tissues;
}

std::optional<Tissue> tissue_called(std::string_view structure) {
  std::string wanted = lower_case(std::string(structure));
  if (wanted == "tooth" || wanted == "dentin") wanted = "dentine";
  if (wanted == "soft") wanted = "pulp";
  for (const Tissue& tissue : known_tissues())
    if (tissue.name == wanted) return tissue;
  return std::nullopt;
}

double mass_attenuation(Element element, double energy_kev) {
  if (!(energy_kev >= least_energy_kev && energy_kev <= most_energy_kev))
    throw UsageError(fmt::format("{:g} keV is beyond the table of attenuation", energy_kev),
                     fmt::format("Give {:g} to {:g} keV.", least_energy_kev, most_energy_kev));
  std::size_t above = 1;
  while (above + 1 < table_kev.size() && table_kev[above] < energy_kev) ++above;
  const auto& row = table[static_cast<std::size_t>(element)];
  const double part =
      portable::log(energy_kev / table_kev[above - 1]) / portable::log(table_kev[above] / table_kev[above - 1]);
  return row[above - 1] * portable::pow(row[above] / row[above - 1], part);
}

double linear_attenuation(const Tissue& tissue, double energy_kev) {
  double per_weight = 0;
  for (std::size_t i = 0; i < element_count; ++i)
    per_weight += tissue.share[i] * mass_attenuation(static_cast<Element>(i), energy_kev);
  constexpr double per_cm_to_per_mm = 0.1;
  return per_cm_to_per_mm * tissue.density * per_weight;
}

double effective_energy_kev(double kv) { return 0.5 * kv; }

}  // namespace odontoscope
