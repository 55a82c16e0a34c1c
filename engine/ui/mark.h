#pragma once
// How something is, for signs and colours that go with words.

namespace odontoscope {

enum class Mark { good, look, bad };

}  // namespace odontoscope
