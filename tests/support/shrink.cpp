#include "tests/support/shrink.h"

#include <algorithm>

#include "tests/support/plane_check.h"

namespace odontoscope::test {
namespace {

using Clock = std::chrono::steady_clock;

class Shrinker {
 public:
  Shrinker(LinkedStack linked, const std::function<bool(const LinkedStack&)>& fails, std::chrono::seconds time)
      : now_(std::move(linked)), fails_(fails), end_(Clock::now() + time) {}

  LinkedStack run() {
    bool smaller = true;
    while (smaller && in_time()) {
      smaller = drop_links();
      smaller = drop_slices() || smaller;
      smaller = drop_contours() || smaller;
      smaller = drop_points() || smaller;
    }
    return now_;
  }

 private:
  bool in_time() const { return Clock::now() < end_; }

  bool take_if_failing(const LinkedStack& candidate) {
    if (!in_time() || !breach(candidate.stack).empty() || !fails_(candidate)) return false;
    now_ = candidate;
    return true;
  }

  bool drop_links() {
    bool any = false;
    for (std::size_t i = 0; i < now_.links.size();) {
      LinkedStack candidate = now_;
      candidate.links.erase(candidate.links.begin() + long(i));
      if (take_if_failing(candidate))
        any = true;
      else
        ++i;
    }
    return any;
  }

  bool drop_slices() {
    bool any = false;
    for (std::size_t k = 0; k < now_.stack.slices.size();) {
      LinkedStack candidate = now_;
      candidate.stack.slices.erase(candidate.stack.slices.begin() + long(k));
      std::erase_if(candidate.links, [&](const Link& link) { return link.slice == k || link.slice + 1 == k; });
      for (Link& link : candidate.links)
        if (link.slice > k) --link.slice;
      if (take_if_failing(candidate))
        any = true;
      else
        ++k;
    }
    return any;
  }

  /// Contour c of slice k is gone: so are its links, and those behind it move up.
  static void forget(std::vector<Link>& links, std::size_t k, std::size_t c) {
    std::erase_if(links,
                  [&](const Link& l) { return (l.slice == k && l.lower == c) || (l.slice + 1 == k && l.upper == c); });
    for (Link& link : links) {
      if (link.slice == k && link.lower > c) --link.lower;
      if (link.slice + 1 == k && link.upper > c) --link.upper;
    }
  }

  bool drop_contours() {
    bool any = false;
    for (std::size_t k = 0; k < now_.stack.slices.size(); ++k)
      for (std::size_t c = 0; c < now_.stack.slices[k].contours.size();) {
        LinkedStack candidate = now_;
        auto& contours = candidate.stack.slices[k].contours;
        contours.erase(contours.begin() + long(c));
        forget(candidate.links, k, c);
        if (take_if_failing(candidate))
          any = true;
        else
          ++c;
      }
    return any;
  }

  bool drop_points() {
    bool any = false;
    for (std::size_t run : {16, 4, 1})
      for (std::size_t k = 0; k < now_.stack.slices.size(); ++k)
        for (std::size_t c = 0; c < now_.stack.slices[k].contours.size(); ++c)
          for (std::size_t i = 0; i + run <= now_.stack.slices[k].contours[c].points.size();) {
            LinkedStack candidate = now_;
            auto& points = candidate.stack.slices[k].contours[c].points;
            points.erase(points.begin() + long(i), points.begin() + long(i + run));
            if (take_if_failing(candidate))
              any = true;
            else
              i += run;
          }
    return any;
  }

  LinkedStack now_;
  const std::function<bool(const LinkedStack&)>& fails_;
  Clock::time_point end_;
};

}  // namespace

ContourStack shrunk(ContourStack stack, const std::function<bool(const ContourStack&)>& fails,
                    std::chrono::seconds time) {
  const std::function<bool(const LinkedStack&)> fails_alone = [&](const LinkedStack& candidate) {
    return fails(candidate.stack);
  };
  return Shrinker({std::move(stack), {}}, fails_alone, time).run().stack;
}

LinkedStack shrunk(LinkedStack linked, const std::function<bool(const LinkedStack&)>& fails,
                   std::chrono::seconds time) {
  return Shrinker(std::move(linked), fails, time).run();
}

}  // namespace odontoscope::test
