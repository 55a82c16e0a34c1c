#pragma once
// See pool.h.

#include <tbb/pool.h>

#include <cstddef>

namespace tbb {

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t threads) : bound_(static_cast<int>(threads)) {}

 private:
  detail::Bound bound_;
};

}  // namespace tbb
