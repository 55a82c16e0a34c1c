#include "tests/support/shrink.h"

#include <algorithm>

#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

using Clock = std::chrono::steady_clock;

class Shrinker {
 public:
  Shrinker(ContourStack stack, const std::function<bool(const ContourStack&)>& fails, std::chrono::seconds time)
      : stack_(std::move(stack)), fails_(fails), end_(Clock::now() + time) {}

  ContourStack run() {
    bool smaller = true;
    while (smaller && in_time()) {
      smaller = drop_slices();
      smaller = drop_contours() || smaller;
      smaller = drop_points() || smaller;
    }
    return stack_;
  }

 private:
  bool in_time() const { return Clock::now() < end_; }

  bool take_if_failing(const ContourStack& candidate) {
    if (!in_time() || !breach(candidate).empty() || !fails_(candidate)) return false;
    stack_ = candidate;
    return true;
  }

  bool drop_slices() {
    bool any = false;
    for (std::size_t k = 0; k < stack_.slices.size();) {
      ContourStack candidate = stack_;
      candidate.slices.erase(candidate.slices.begin() + long(k));
      if (take_if_failing(candidate)) any = true;
      else ++k;
    }
    return any;
  }

  bool drop_contours() {
    bool any = false;
    for (std::size_t k = 0; k < stack_.slices.size(); ++k)
      for (std::size_t c = 0; c < stack_.slices[k].contours.size();) {
        ContourStack candidate = stack_;
        auto& contours = candidate.slices[k].contours;
        contours.erase(contours.begin() + long(c));
        if (take_if_failing(candidate)) any = true;
        else ++c;
      }
    return any;
  }

  bool drop_points() {
    bool any = false;
    for (std::size_t run : {16, 4, 1})
      for (std::size_t k = 0; k < stack_.slices.size(); ++k)
        for (std::size_t c = 0; c < stack_.slices[k].contours.size(); ++c)
          for (std::size_t i = 0; i + run <= stack_.slices[k].contours[c].points.size();) {
            ContourStack candidate = stack_;
            auto& points = candidate.slices[k].contours[c].points;
            points.erase(points.begin() + long(i), points.begin() + long(i + run));
            if (take_if_failing(candidate)) any = true;
            else i += run;
          }
    return any;
  }

  ContourStack stack_;
  const std::function<bool(const ContourStack&)>& fails_;
  Clock::time_point end_;
};

}  // namespace

ContourStack shrunk(ContourStack stack, const std::function<bool(const ContourStack&)>& fails,
                    std::chrono::seconds time) {
  return Shrinker(std::move(stack), fails, time).run();
}

}  // namespace odontoscope::test
