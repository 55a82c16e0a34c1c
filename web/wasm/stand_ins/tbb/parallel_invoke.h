#pragma once
// See parallel_for.h.

namespace tbb {

template <class... Works>
void parallel_invoke(const Works&... works) {
  (works(), ...);
}

}  // namespace tbb
