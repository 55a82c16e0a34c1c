// Coefficients of mixtures, against tables of the mixtures themselves.
#include "recon/radiograph/tissue.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/core/error.h"

namespace odontoscope::test {
namespace {

struct Tabled {
  const char* tissue;
  double energy_kev, per_weight;  // cm^2/g
};

// Hubbell and Seltzer, NISTIR 5632, table 4: what the table of elements is not made from.
TEST(Tissue, WeakensAsTheTablesOfItsMixtureSay) {
  for (const Tabled& row : {Tabled{"bone", 20, 4.001},
                            {"bone", 30, 1.331},
                            {"bone", 40, 0.6655},
                            {"bone", 60, 0.3148},
                            {"bone", 80, 0.2229},
                            {"pulp", 20, 0.8230},
                            {"pulp", 30, 0.3790},
                            {"pulp", 40, 0.2688},
                            {"pulp", 60, 0.2048},
                            {"pulp", 80, 0.1823},
                            {"water", 20, 0.8096},
                            {"water", 30, 0.3756},
                            {"water", 40, 0.2683},
                            {"water", 60, 0.2059},
                            {"water", 80, 0.1837}}) {
    const Tissue tissue = *tissue_called(row.tissue);
    EXPECT_NEAR(linear_attenuation(tissue, row.energy_kev), 0.1 * tissue.density * row.per_weight,
                0.015 * 0.1 * tissue.density * row.per_weight)
        << row.tissue << " " << row.energy_kev;
  }
}

TEST(Tissue, BetweenTheEnergiesOfTheTableIsSmooth) {
  const Tissue enamel = *tissue_called("enamel");
  double before = linear_attenuation(enamel, 10);
  for (double energy = 10.5; energy <= 100; energy += 0.5) {
    const double here = linear_attenuation(enamel, energy);
    EXPECT_LT(here, before) << energy;
    EXPECT_GT(here, 0.8 * before) << energy;
    before = here;
  }
}

TEST(Tissue, EnamelWeakensMostAndPulpLeast) {
  for (const double energy : {15.0, 35.0, 75.0}) {
    const auto of = [&](const char* name) { return linear_attenuation(*tissue_called(name), energy); };
    EXPECT_GT(of("enamel"), 1.4 * of("dentine"));
    EXPECT_GT(of("dentine"), 2 * of("pulp"));
  }
}

TEST(Tissue, IsKnownByItsName) {
  EXPECT_EQ(tissue_called("Enamel")->name, "enamel");
  EXPECT_EQ(tissue_called("tooth")->name, "dentine");
  EXPECT_EQ(tissue_called("dentin")->name, "dentine");
  EXPECT_FALSE(tissue_called("crown"));
  EXPECT_FALSE(tissue_called(""));
  for (const Tissue& tissue : known_tissues()) {
    double sum = 0;
    for (const double share : tissue.share) sum += share;
    EXPECT_NEAR(sum, 1, 1e-12) << tissue.name;
  }
}

TEST(Tissue, IsNotKnownBeyondTheTable) {
  EXPECT_THROW(mass_attenuation(Element::calcium, 9.9), UsageError);
  EXPECT_THROW(mass_attenuation(Element::calcium, 100.1), UsageError);
  EXPECT_THROW(mass_attenuation(Element::calcium, std::nan("")), UsageError);
  EXPECT_DOUBLE_EQ(mass_attenuation(Element::calcium, 100), 0.2571);
  EXPECT_DOUBLE_EQ(mass_attenuation(Element::calcium, 10), 93.41);
}

}  // namespace
}  // namespace odontoscope::test
