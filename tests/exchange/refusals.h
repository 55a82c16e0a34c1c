#pragma once
// Why a reader of contours refuses what it is given, and what it makes of files cut short.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "recon/core/error.h"
#include "recon/core/polygon.h"
#include "recon/exchange/read_rtstruct.h"

namespace odontoscope {

template <class Read>
std::string cause_of(Read read) {
  try {
    read();
    return "accepted";
  } catch (const InputError& error) {
    EXPECT_FALSE(error.place().file.empty()) << error.what();
    return error.cause();
  }
}

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), with);
}

/// Every kilobyte, and every byte of small files: accepted or an InputError, never anything else.
template <class Parse>
void truncate(const std::string& bytes, Parse parse) {
  const std::size_t step = bytes.size() > 20'000 ? 1024 : 1;
  for (std::size_t n = 0; n < bytes.size(); n += step) {
    EXPECT_NO_THROW(cause_of([&] { parse(bytes.substr(0, n)); })) << n;
  }
}

// --- Reconstruct -----------------------------------------------------------------------------------------------------
inline std::string set_cause(const std::string& bytes, const std::vector<std::string>& wanted = {}) {
  return cause_of([&] { parse_rtstruct(bytes, "file", wanted); });
}

inline double enclosed(const Contour& contour) { return std::abs(signed_area(contour.points)); }

}  // namespace odontoscope
