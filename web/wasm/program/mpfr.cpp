// The few functions of MPFR that CGAL 5.5 calls, for the one thing that it wants of them: the double next to an exact
// number, away from zero, to be one bound of an interval (To_interval of Gmpq, Gmpz and their likes in Boost). MPFR as
// a whole is not built for WebAssembly. What else is declared in mpfr.h stays undefined, so that a call to it does not
// link.
#include <gmp.h>
#include <mpfr.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace {

static_assert(sizeof(mp_limb_t) == sizeof(double));

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Numbers here have 53 bits: they are kept as doubles where MPFR has its first limb.
void keep(mpfr_ptr in, double value) { std::memcpy(in->_mpfr_d, &value, sizeof value); }

/// `towards_zero` is the number rounded towards zero, `beyond` the sign of what was cut off.
int keep_away_from_zero(mpfr_ptr in, double towards_zero, int beyond, mpfr_rnd_t rounding) {
  if (rounding != MPFR_RNDA) std::abort();  // nothing else is asked for
  keep(in, beyond == 0 ? towards_zero : std::nextafter(towards_zero, beyond > 0 ? infinity : -infinity));
  return beyond;
}

}  // namespace

extern "C" {

int mpfr_set_q(mpfr_ptr to, mpq_srcptr from, mpfr_rnd_t rounding) {
  const double towards_zero = mpq_get_d(from);
  if (!std::isfinite(towards_zero)) return keep_away_from_zero(to, towards_zero, mpq_sgn(from), rounding);
  mpq_t exact;
  mpq_init(exact);
  mpq_set_d(exact, towards_zero);
  const int beyond = mpq_cmp(from, exact);
  mpq_clear(exact);
  return keep_away_from_zero(to, towards_zero, beyond, rounding);
}

int mpfr_set_z(mpfr_ptr to, mpz_srcptr from, mpfr_rnd_t rounding) {
  const double towards_zero = mpz_get_d(from);
  const int beyond = std::isfinite(towards_zero) ? mpz_cmp_d(from, towards_zero) : mpz_sgn(from);
  return keep_away_from_zero(to, towards_zero, beyond, rounding);
}

double mpfr_get_d(mpfr_srcptr from, mpfr_rnd_t) {
  double value = 0;
  std::memcpy(&value, from->_mpfr_d, sizeof value);
  return value;
}

// Doubles have their own smallest numbers, and know them without being told.
mpfr_exp_t mpfr_get_emin() { return -1073; }
int mpfr_set_emin(mpfr_exp_t) { return 0; }
int mpfr_subnormalize(mpfr_ptr, int beyond, mpfr_rnd_t) { return beyond; }

}  // extern "C"
