#pragma once
// The gate between data and engine: a stack that passes is safe for everything behind.

#include <memory>
#include <utility>

#include "recon/core/progress.h"
#include "recon/input/contour_stack.h"

namespace odontoscope {

/// A stack that has passed `validate`, the only way to one: what engines take. It never changes, so what was checked
/// once stays true; copies share it.
class ValidStack {
 public:
  const ContourStack& operator*() const { return *stack_; }
  const ContourStack* operator->() const { return stack_.get(); }
  operator const ContourStack&() const { return *stack_; }

 private:
  // NOLINTNEXTLINE(performance-unnecessary-value-param): it moves the stack on
  friend ValidStack validate(ContourStack stack, const Progress& progress);
  explicit ValidStack(ContourStack stack) : stack_(std::make_shared<const ContourStack>(std::move(stack))) {}
  std::shared_ptr<const ContourStack> stack_;
};

/// Checks every rule of contour_stack.h with exact predicates and throws InputError for the first breach, naming
/// file, slice, contour, point and place. Slices and contours are numbered as in `stack`.
///
/// Causes: empty-stack (no slice, or no contour in any), single-slice (fewer than two slices), repeated-z,
/// not-finite, too-large, too-few-points, repeated-point (two equal points of one contour, neighbours or not),
/// zero-area, self-crossing (crossing, touching itself or folding back), contours-cross, contours-touch (of one
/// structure), too-many-slices / -contours / -points / -structures, bad-name (empty, too long, control characters).
///
/// Cost: O(n log n) per slice by a plane sweep.
ValidStack validate(ContourStack stack, const Progress& progress = {});

/// The same stack in the order the engines want: slices by ascending z; in each structure's slice, outer contours
/// counter-clockwise seen from +z, holes clockwise (nesting depth decides). Contours keep their order within the slice,
/// and points keep their first point. Precondition: `validate` passed. `original_slice[i]` is the number that sorted
/// slice i had in `stack`.
struct OrderedStack {
  ContourStack stack;
  std::vector<std::size_t> original_slice;
};
OrderedStack ordered(const ContourStack& stack);

/// `stack` with every contour of the named structures renamed to their joint name "a+b", so that they are
/// reconstructed together (a pulp inside a tooth becomes its cavity). Throws InputError unknown-structure if a name is
/// not there. The result must be validated again: contours that belonged to different structures may cross or touch.
ContourStack together(const ContourStack& stack, const std::vector<std::string>& structures);

/// Names of the structures in order of first appearance.
std::vector<std::string> structures_of(const ContourStack& stack);

}  // namespace odontoscope
