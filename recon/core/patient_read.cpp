#include "recon/core/patient_read.h"

#include "recon/core/progress.h"

namespace odontoscope {

std::ptrdiff_t read_some(const system::Descriptor& from, char* to, std::size_t count, const std::stop_token& stop) {
  constexpr int look_every = 100;  // milliseconds
  for (;;) {
    if (stop.stop_requested()) throw Cancelled{};
    const std::ptrdiff_t got = system::read_within(from, to, count, look_every);
    if (got != system::nothing_yet) return got;
  }
}

}  // namespace odontoscope
