#pragma once
// See pool.h.

#include <tbb/pool.h>

#include <cstddef>
#include <functional>

namespace tbb {

template <class... Works>
void parallel_invoke(const Works&... works) {
  const std::function<void()> all[] = {std::cref(works)...};
  detail::run(sizeof...(works), [&](std::size_t i) { all[i](); });
}

}  // namespace tbb
