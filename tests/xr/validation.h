#pragma once
// OpenXR's core-validation layer, which checks every call against the specification, and what it said.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace odontoscope::testing_support {

inline constexpr const char* validation_layer = "XR_APILAYER_LUNARG_core_validation";

/// For sessions that are opened from now on in this process.
inline void report_validation_to(const char* file) {
  setenv("XR_CORE_VALIDATION_EXPORT_TYPE", "text", 1);
  setenv("XR_CORE_VALIDATION_FILE_NAME", file, 1);
}

/// It reports that it begins and that it ends, and nothing else.
inline void expect_silent_validation(const char* file) {
  std::ifstream said(file);
  int lines = 0;
  for (std::string line; std::getline(said, line);) {
    if (line.empty()) continue;
    ++lines;
    EXPECT_NE(line.find("VALID_DEBUG | VUID-CoreValidation-"), std::string::npos) << line;
  }
  EXPECT_EQ(lines, 2);
}

}  // namespace odontoscope::testing_support
