#pragma once
// Identifiers of new DICOM objects, made from their content: the same content has the same identifier, another has
// another.
//
// UUIDs of version 5 (RFC 4122, SHA-1) below 2.25, as DICOM PS3.5, B.2, has them.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace odontoscope {

/// FIPS 180-4. Not for secrets.
std::array<std::uint8_t, 20> sha1(std::string_view bytes);

class DerivedUid {
 public:
  /// Of all that the objects are made of.
  explicit DerivedUid(std::string_view content);
  /// Of one of them: "instance", "series" ...
  std::string of(std::string_view role) const;

 private:
  std::string digest_;
};

/// Digits and points, at most 64, as identifiers are.
bool is_uid(std::string_view text);

}  // namespace odontoscope
