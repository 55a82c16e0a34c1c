#pragma once
// splitmix64 and what is drawn from it. The standard library's distributions differ between implementations; a seed
// printed by one machine must mean the same stack on every other.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace odontoscope::test {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// 0 <= value < 1, 53 bits.
  double unit() { return double(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// 0 <= value < count
  int below(int count) { return int(bits() % std::uint64_t(count)); }
  /// low <= value <= high
  int whole(int low, int high) { return low + below(high - low + 1); }
  bool chance(double probability) { return unit() < probability; }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[std::size_t(below(int(i)))]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace odontoscope::test
