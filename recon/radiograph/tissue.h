#pragma once
// How much tissues weaken X-rays.
//
// Mass attenuation coefficients of the elements: Hubbell and Seltzer, "Tables of X-Ray Mass Attenuation Coefficients",
// NISTIR 5632, 1995 (https://www.nist.gov/pml/x-ray-mass-attenuation-coefficients), table 3, coherent scattering
// included. A tissue is a mixture of elements: its coefficient is the sum of theirs by weight, times its density.
//
// Composition by weight: enamel 96 % mineral, 1 % protein, 3 % water; dentine 70 % mineral, 20 % protein, 10 % water
// (Nanci, "Ten Cate's Oral Histology"); the mineral is taken as hydroxyapatite, Ca10(PO4)6(OH)2. Soft tissue and
// cortical bone as in ICRU Report 44, 1989; what they hold of other elements (1 % at most) is counted to the nearest
// below: sodium and magnesium to oxygen, chlorine to sulphur, potassium to calcium. Cementum is taken as bone.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope {

enum class Element { hydrogen, carbon, nitrogen, oxygen, phosphorus, sulphur, calcium };
inline constexpr std::size_t element_count = 7;

struct Tissue {
  std::string name;
  double density = 1;                         // g/cm^3
  std::array<double, element_count> share{};  // by weight, 1 in all
};

/// Enamel, dentine, pulp (soft tissue), cementum, bone, water.
const std::vector<Tissue>& known_tissues();

/// Of a structure's name, whatever its case: a tissue of that name, "tooth" and "dentin" as dentine, "soft" as pulp;
/// nothing for any other.
std::optional<Tissue> tissue_called(std::string_view structure);

inline constexpr double least_energy_kev = 10, most_energy_kev = 100;

/// cm^2/g at `energy_kev`, between least_energy_kev and most_energy_kev: between the energies of the table along
/// straight lines in logarithms. Throws UsageError for an energy beyond.
double mass_attenuation(Element element, double energy_kev);

/// 1/mm.
double linear_attenuation(const Tissue& tissue, double energy_kev);

inline constexpr double least_kv = 30, most_kv = 150, usual_kv = 70;

/// The energy of the single line that stands for a tube's whole spectrum: half of its peak. Filtered diagnostic beams
/// are told to have a third to a half (Bushberg et al., "The Essential Physics of Medical Imaging"), and teeth, which
/// swallow the softest rays first, are nearer to the half. Beam hardening itself is not modelled. Precondition: `kv`
/// from least_kv to most_kv.
double effective_energy_kev(double kv);

}  // namespace odontoscope
