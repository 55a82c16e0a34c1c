#include "recon/core/patient_read.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "recon/core/progress.h"

namespace odontoscope {

int open_to_read(const std::string& file) { return ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); }

std::ptrdiff_t read_some(int descriptor, char* to, std::size_t count, const std::stop_token& stop) {
  constexpr int look_every = 100;  // milliseconds
  for (;;) {
    if (stop.stop_requested()) throw Cancelled{};
    pollfd waiting{descriptor, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, look_every);
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t got = ::read(descriptor, to, count);
    if (got >= 0) return got;
    if (errno != EINTR && errno != EAGAIN) return -1;
  }
}

}  // namespace odontoscope
