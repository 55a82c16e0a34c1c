#include "recon/between/blend_units.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>

#include "recon/between/bridges.h"
#include "recon/core/error.h"
#include "recon/core/union_find.h"

namespace odontoscope::between {
namespace {

const Outline no_contours;

/// Contours of both slices in one numbering, the lower slice's first, and last the outside.
class Linked {
 public:
  Linked(const SliceSet& slices, const Surroundings& surroundings)
      : slices_(slices),
        lower_(slices.outlines[at_lower]->size()),
        upper_(slices.outlines[at_upper]->size()),
        sets_(lower_ + upper_ + 1) {
    for (const ContourLink& link : surroundings.material)
      sets_.join(outer(at_lower, link.lower), outer(at_upper, link.upper));
    for (const ContourLink& link : surroundings.voids)
      sets_.join(hole(at_lower, link.lower), hole(at_upper, link.upper));
  }

  std::uint32_t root(std::size_t slice, std::size_t contour) { return sets_.find(number(slice, contour)); }
  std::uint32_t outside_root() { return sets_.find(static_cast<std::uint32_t>(lower_ + upper_)); }
  std::size_t count() const { return lower_ + upper_ + 1; }

 private:
  std::uint32_t number(std::size_t slice, std::size_t contour) const {
    return static_cast<std::uint32_t>(slice == at_lower ? contour : lower_ + contour);
  }
  std::uint32_t outer(std::size_t slice, std::size_t contour) const {
    if (contour >= slices_.facts[slice].size() || !slices_.facts[slice][contour].outer()) {
      throw InternalError("a link of material names contour " + std::to_string(contour) +
                          ", which is no outer contour");
    }
    return number(slice, contour);
  }
  std::uint32_t hole(std::size_t slice, std::size_t contour) const {
    if (contour == outside) return static_cast<std::uint32_t>(lower_ + upper_);
    if (contour >= slices_.facts[slice].size() || slices_.facts[slice][contour].outer()) {
      throw InternalError("a link of voids names contour " + std::to_string(contour) + ", which is no hole");
    }
    return number(slice, contour);
  }

  const SliceSet& slices_;
  std::size_t lower_, upper_;
  UnionFind sets_;
};

class Planner {
 public:
  Planner(const SliceSet& slices, const Surroundings& surroundings)
      : slices_(slices), surroundings_(surroundings), linked_(slices, surroundings) {
    for (const std::size_t slice : {at_lower, at_upper}) order_[slice] = outside_in(slices.facts[slice]);
    partners_[at_lower] = partners(slices.facts[at_lower], slices.facts[at_before]);
    partners_[at_upper] = partners(slices.facts[at_upper], slices.facts[at_after]);
  }

  BlendPlan plan() {
    list_members();
    BlendPlan result;
    std::vector<std::size_t> void_number(linked_.count(), ContourFacts::none);
    for (std::uint32_t root = 0; root < linked_.count(); ++root) {
      if (!is_void_[root] || members_[root].empty() || root == linked_.outside_root()) continue;
      void_number[root] = result.voids.size();
      result.voids.push_back(void_unit(root));
    }
    std::vector<std::size_t> group_number(linked_.count(), ContourFacts::none);
    for (std::uint32_t root = 0; root < linked_.count(); ++root) {
      if (is_void_[root] || members_[root].empty()) continue;
      group_number[root] = result.groups.size();
      BlendGroup& group = result.groups.emplace_back(BlendGroup{material_unit(root), {}});
      for (const std::uint32_t owned : voids_of_[root]) group.voids.push_back(void_number[owned]);
    }
    add_bridges(result, group_number);
    return result;
  }

 private:
  struct Member {
    std::size_t slice, contour;
  };

  void list_members() {
    members_.resize(linked_.count());
    is_void_.assign(linked_.count(), false);
    is_void_[linked_.outside_root()] = true;
    owners_.resize(linked_.count());
    voids_of_.resize(linked_.count());
    for (const std::size_t slice : {at_lower, at_upper}) {
      for (std::size_t c = 0; c < slices_.facts[slice].size(); ++c) {
        const std::uint32_t root = linked_.root(slice, c);
        members_[root].push_back({slice, c});
        if (slices_.facts[slice][c].outer()) continue;
        is_void_[root] = true;
        if (slices_.facts[slice][c].parent == ContourFacts::none)
          throw InternalError("a hole lies in no outer contour");
        const std::uint32_t owner = linked_.root(slice, slices_.facts[slice][c].parent);
        owners_[root].insert(owner);
        if (root != linked_.outside_root()) voids_of_[owner].insert(root);
      }
    }
  }

  BlendUnit material_unit(std::uint32_t root) {
    return unit([&](std::size_t slice, std::size_t c) {
      const ContourFacts& facts = slices_.facts[slice][c];
      if (facts.outer()) return linked_.root(slice, c) == root ? Change::enter : Change::none;
      const bool opens = linked_.root(slice, c) == linked_.outside_root();
      return opens && linked_.root(slice, facts.parent) == root ? Change::leave : Change::none;
    });
  }

  BlendUnit void_unit(std::uint32_t root) {
    return unit([&](std::size_t slice, std::size_t c) {
      const std::uint32_t own = linked_.root(slice, c);
      if (!slices_.facts[slice][c].outer()) return own == root ? Change::enter : Change::none;
      return owners_[root].contains(own) ? Change::leave : Change::none;
    });
  }

  /// What carries material is a group of its own; a void is taken out of the material that it lies in.
  void add_bridges(BlendPlan& plan, const std::vector<std::size_t>& group_number) {
    for (Bridge& bridge : bridges(slices_, surroundings_)) {
      if (!bridge.hollow) {
        plan.groups.push_back({std::move(bridge.unit), {}});
        continue;
      }
      const std::size_t owner = linked_.root(bridge.slice, slices_.facts[bridge.slice][bridge.contour].parent);
      plan.groups[group_number[owner]].voids.push_back(plan.voids.size());
      plan.voids.push_back(std::move(bridge.unit));
    }
  }

  enum class Change { none, enter, leave };

  /// What a contour does to the unit's shape, from outside in; those that change nothing are not of its boundary.
  template <class Rule>
  BlendUnit unit(const Rule& rule) {
    BlendUnit result;
    for (const std::size_t slice : {at_lower, at_upper}) {
      std::vector<bool> within(slices_.facts[slice].size(), false);
      std::vector<std::size_t> boundary;
      for (const std::size_t c : order_[slice]) {
        const std::size_t parent = slices_.facts[slice][c].parent;
        const bool around = parent != ContourFacts::none && within[parent];
        const Change change = rule(slice, c);
        within[c] = change == Change::none ? around : change == Change::enter;
        if (within[c] != around) boundary.push_back(c);
      }
      fill(result, slice, boundary);
    }
    return result;
  }

  void fill(BlendUnit& unit, std::size_t slice, const std::vector<std::size_t>& boundary) {
    for (const std::size_t c : boundary) unit.shapes[slice].push_back((*slices_.outlines[slice])[c]);
    unit.presence[slice] = boundary.empty() ? Presence::gone : Presence::shape;
    const std::size_t beyond = slice == at_lower ? at_before : at_after;
    const Outline& outline = *slices_.outlines[beyond];
    unit.presence[beyond] = outline.empty() ? Presence::unused : unit.presence[slice];
    for (const std::size_t c : boundary) {
      const std::size_t partner = outline.empty() ? ContourFacts::none : partners_[slice][c];
      if (partner == ContourFacts::none) {
        unit.shapes[beyond].clear();
        unit.presence[beyond] = Presence::unused;
        return;
      }
      unit.shapes[beyond].push_back(outline[partner]);
    }
  }

  const SliceSet& slices_;
  const Surroundings& surroundings_;
  Linked linked_;
  std::array<std::vector<std::size_t>, slices_used> order_, partners_;
  std::vector<std::vector<Member>> members_;                // by root
  std::vector<bool> is_void_;                               // by root
  std::vector<std::set<std::uint32_t>> owners_, voids_of_;  // by root of voids, of material
};

}  // namespace

SliceSet::SliceSet(const Surroundings& surroundings)
    : outlines{surroundings.before, surroundings.lower, surroundings.upper, surroundings.after},
      z{surroundings.z_before, surroundings.z_lower, surroundings.z_upper, surroundings.z_after} {
  for (std::size_t n = 0; n < slices_used; ++n) {
    if (!outlines[n]) outlines[n] = &no_contours;
    facts[n] = facts_of(*outlines[n]);
  }
}

double SliceSet::larger_side() const {
  Box box;
  for (const std::size_t slice : {at_lower, at_upper}) {
    for (const ContourFacts& contour : facts[slice]) box.take(contour.box);
  }
  return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

BlendPlan blend_plan(const SliceSet& slices, const Surroundings& surroundings) {
  return Planner(slices, surroundings).plan();
}

}  // namespace odontoscope::between
