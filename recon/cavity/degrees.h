#pragma once

namespace odontoscope {

inline constexpr double degrees_per_radian = 57.29577951308232;

}  // namespace odontoscope
