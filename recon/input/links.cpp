#include "recon/input/links.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "recon/input/planar_sweep.h"
#include "recon/input/structure_names.h"
#include "recon/input/validate.h"

namespace odontoscope {
namespace {

class LinkCheck {
 public:
  LinkCheck(const std::vector<Link>& links, const ContourStack& stack, const std::string& file)
      : links_(links), stack_(stack), structures_(structures_of(stack)) {
    std::sort(structures_.begin(), structures_.end());
    place_.file = file;
  }

  void run() const {
    for (std::size_t i = 0; i < links_.size(); ++i) check(i);
    look_for_contradictions();
  }

 private:
  std::string in_words(std::size_t i) const {
    const Link& link = links_[i];
    return fmt::format("link {} ({}, slice {}, {} to {})", i, in_quotes(link.structure), link.slice, link.lower,
                       link.upper);
  }

  [[noreturn]] void refuse(const char* cause, std::size_t i, const std::string& wrong, std::string_view remedy) const {
    throw InputError(cause, place_, in_words(i) + ": " + wrong, remedy);
  }

  void check(std::size_t i) const {
    const Link& link = links_[i];
    if (!std::binary_search(structures_.begin(), structures_.end(), link.structure)) {
      refuse("link-unknown-structure", i, "the stack has no such structure",
             "Name one of the stack's structures; those taken together have a joint name such as \"tooth+pulp\"");
    }
    if (link.slice >= stack_.slices.size() || link.slice + 1 == stack_.slices.size()) {
      refuse("link-unknown-slice", i, fmt::format("the lower slice must be one of 0 to {}", stack_.slices.size() - 2),
             "Slices are counted from 0 by ascending z; a link goes from one to the next");
    }
    check_contour(i, link.slice, link.lower);
    check_contour(i, link.slice + 1, link.upper);
  }

  void check_contour(std::size_t i, std::size_t slice, std::size_t number) const {
    const std::vector<Contour>& contours = stack_.slices[slice].contours;
    if (number >= contours.size()) {
      refuse("link-unknown-contour", i, fmt::format("slice {} has {} contours, counted from 0", slice, contours.size()),
             "Contours are counted as they stand in their slice, all structures together");
    }
    if (contours[number].structure != links_[i].structure) {
      refuse("link-wrong-structure", i,
             fmt::format("contour {} of slice {} belongs to {}", number, slice, in_quotes(contours[number].structure)),
             "Link contours of one structure");
    }
    if (!counter_clockwise(contours[number].points)) {
      refuse("link-not-outer", i, fmt::format("contour {} of slice {} is a hole", number, slice),
             "Name a region by its outer contour");
    }
  }

  void look_for_contradictions() const {
    std::vector<std::size_t> sorted(links_.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    const auto pair = [this](std::size_t i) { return std::tie(links_[i].slice, links_[i].lower, links_[i].upper); };
    std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return pair(a) < pair(b); });
    for (std::size_t k = 1; k < sorted.size(); ++k) {
      const std::size_t a = sorted[k - 1], b = sorted[k];
      if (pair(a) != pair(b) || links_[a].connect == links_[b].connect) continue;
      refuse("link-contradiction", b, fmt::format("link {} says the opposite of the same pair", a),
             "Remove one of the two");
    }
  }

  const std::vector<Link>& links_;
  const ContourStack& stack_;
  std::vector<std::string> structures_;
  Place place_;
};

}  // namespace

void validate_links(const std::vector<Link>& links, const ContourStack& ordered_stack, const std::string& file) {
  LinkCheck(links, ordered_stack, file).run();
}

}  // namespace odontoscope
