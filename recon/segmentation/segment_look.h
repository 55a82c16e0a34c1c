#pragma once
// What a structure's name tells: its code and the colour to show it in.
//
// Tooth has its code of SNOMED CT. Enamel, dentine, pulp and cementum have codes of our own (designator 99ODONTO), with
// the tooth as the region that they are of: no code of SNOMED CT for them could be confirmed. Any other name is an
// anatomical structure.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace odontoscope {

struct Code {
  std::string_view value, scheme, meaning;
};

struct SegmentLook {
  Code category, type;
  std::optional<Code> region;
  std::array<std::uint8_t, 3> colour;  // sRGB
};

/// By what the name contains, in whatever letters: "enamel", "dentin", "pulp" ... `number` chooses a colour for names
/// that tell nothing.
SegmentLook look_of(std::string_view name, std::size_t number);

/// L*a*b* as DICOM has it (PS3.3, C.10.7.1.1): of CIE 1976 under D50, adapted after Bradford, in 16 bits.
std::array<std::uint16_t, 3> cie_lab(const std::array<std::uint8_t, 3>& colour);

}  // namespace odontoscope
