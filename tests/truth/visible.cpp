#include "visible.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "recon/core/union_find.h"

namespace odontoscope::test {
namespace {

/// Components of material or void in layers that lie upon each other. Material hangs together by corners (26
/// neighbours), void by faces (6), as in voxel_topology.h.
class Components {
 public:
  Components(const Raster& raster, const std::vector<Mask>& layers, bool material)
      : raster_(raster), material_(material), sets_(0) {
    for (const Mask& layer : layers)
      for (std::size_t row = 0; row < raster.rows; ++row) add_line(layer.data() + row * raster.columns);
    sets_ = UnionFind(runs_.size());
    for (std::size_t line = 0; line + 1 < first_.size(); ++line) join_line(line);
  }

  /// Of a layer, its component at a point that is of the kind asked for.
  std::uint32_t at(std::size_t layer, std::size_t column, std::size_t row) {
    const std::size_t line = layer * raster_.rows + row;
    const auto run =
        std::partition_point(runs_.begin() + offset(first_[line]), runs_.begin() + offset(first_[line + 1]),
                             [column](const Run& r) { return r.end <= column; });
    return sets_.find(static_cast<std::uint32_t>(run - runs_.begin()));
  }

  struct Part {
    std::uint32_t component;
    std::size_t column, row;  // one of its points
  };
  /// Components in one layer, each once.
  std::vector<Part> parts(std::size_t layer) {
    std::vector<Part> found;
    std::set<std::uint32_t> seen;
    for (std::size_t row = 0; row < raster_.rows; ++row) {
      const std::size_t line = layer * raster_.rows + row;
      for (std::size_t run = first_[line]; run < first_[line + 1]; ++run) {
        const std::uint32_t component = sets_.find(static_cast<std::uint32_t>(run));
        if (seen.insert(component).second) found.push_back({component, runs_[run].begin, row});
      }
    }
    return found;
  }

 private:
  struct Run {
    std::size_t begin, end;
  };
  static std::ptrdiff_t offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  void add_line(const std::uint8_t* row) {
    for (std::size_t i = 0; i < raster_.columns;) {
      const std::size_t begin = i;
      const bool is = (row[i] != 0) == material_;
      while (i < raster_.columns && ((row[i] != 0) == material_) == is) ++i;
      if (is) runs_.push_back({begin, i});
    }
    first_.push_back(runs_.size());
  }

  void join_line(std::size_t line) {
    const std::size_t row = line % raster_.rows;
    const bool below = line >= raster_.rows;
    if (row > 0) join(line, line - 1);
    if (below) join(line, line - raster_.rows);
    if (!material_ || !below) return;
    if (row > 0) join(line, line - raster_.rows - 1);
    if (row + 1 < raster_.rows) join(line, line - raster_.rows + 1);
  }

  void join(std::size_t a, std::size_t b) {
    const std::size_t reach = material_ ? 1 : 0;
    std::size_t i = first_[a], j = first_[b];
    while (i < first_[a + 1] && j < first_[b + 1]) {
      if (runs_[i].begin < runs_[j].end + reach && runs_[j].begin < runs_[i].end + reach)
        sets_.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      (runs_[i].end < runs_[j].end ? i : j) += 1;
    }
  }

  Raster raster_;
  bool material_;
  std::vector<Run> runs_;
  std::vector<std::size_t> first_{0};
  UnionFind sets_;
};

/// A slice's regions of material and of void, numbered through the whole stack. The first void is the outside.
struct Section {
  std::vector<Components::Part> material, voids;   // points that lie in them
  std::vector<std::vector<std::uint32_t>> beside;  // for each region of material the voids that border on it, as places
  std::uint32_t first_material = 0, first_void = 0;

  long holes() const { return static_cast<long>(voids.size()) - 1; }
  long euler() const { return static_cast<long>(material.size()) - holes(); }
};

Section section_of(const Raster& raster, const Mask& mask) {
  Components material(raster, {mask}, true), voids(raster, {mask}, false);
  Section section{material.parts(0), voids.parts(0), {}, 0, 0};
  const auto place_of = [](const std::vector<Components::Part>& parts, std::uint32_t component) {
    return static_cast<std::size_t>(
        std::find_if(parts.begin(), parts.end(), [&](const auto& part) { return part.component == component; }) -
        parts.begin());
  };
  std::vector<std::set<std::uint32_t>> beside(section.material.size());
  const auto look = [&](std::size_t column, std::size_t row, std::size_t next_column, std::size_t next_row) {
    const bool is = mask[raster.index(column, row)] != 0, next = mask[raster.index(next_column, next_row)] != 0;
    if (is == next) return;
    if (!is) {
      std::swap(column, next_column);
      std::swap(row, next_row);
    }
    beside[place_of(section.material, material.at(0, column, row))].insert(
        static_cast<std::uint32_t>(place_of(section.voids, voids.at(0, next_column, next_row))));
  };
  for (std::size_t row = 0; row < raster.rows; ++row) {
    for (std::size_t column = 0; column < raster.columns; ++column) {
      if (column + 1 < raster.columns) look(column, row, column + 1, row);
      if (row + 1 < raster.rows) look(column, row, column, row + 1);
    }
  }
  for (const auto& set : beside) section.beside.emplace_back(set.begin(), set.end());
  return section;
}

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Regions of material of two sections, as places in them, that have a point in common seen from above.
Pairs over_each_other(const Raster& raster, const Mask& lower, const Mask& upper) {
  Components below(raster, {lower}, true), above(raster, {upper}, true);
  const auto places = [](const std::vector<Components::Part>& parts) {
    std::map<std::uint32_t, std::uint32_t> place;
    for (std::uint32_t i = 0; i < parts.size(); ++i) place[parts[i].component] = i;
    return place;
  };
  const auto place_below = places(below.parts(0)), place_above = places(above.parts(0));
  Pairs found;
  for (std::size_t row = 0; row < raster.rows; ++row)
    for (std::size_t column = 0; column < raster.columns; ++column)
      if (lower[raster.index(column, row)] && upper[raster.index(column, row)])
        found.emplace(place_below.at(below.at(0, column, row)), place_above.at(above.at(0, column, row)));
  return found;
}

/// Regions that one true component of a slab holds, as places in their sections.
struct Joined {
  std::vector<std::uint32_t> lower, upper;
  bool both() const { return !lower.empty() && !upper.empty(); }
};

std::vector<Joined> joined(Components components, std::size_t last, const std::vector<Components::Part>& lower,
                           const std::vector<Components::Part>& upper) {
  std::map<std::uint32_t, Joined> by_component;
  for (std::uint32_t i = 0; i < lower.size(); ++i)
    by_component[components.at(0, lower[i].column, lower[i].row)].lower.push_back(i);
  for (std::uint32_t i = 0; i < upper.size(); ++i)
    by_component[components.at(last, upper[i].column, upper[i].row)].upper.push_back(i);
  std::vector<Joined> all;
  for (auto& [component, of] : by_component) all.push_back(std::move(of));
  return all;
}

/// A slab's layers without the passages that neither slice shows: what lies, seen from above, over nothing of its kind
/// in either slice, and joins regions all of which go on from one slice to the other without it. Where it begins or
/// ends in a region that goes on to nothing else, that region tells of it.
class ShownPassages {
 public:
  ShownPassages(const Raster& raster, const std::vector<Mask>& layers, bool material)
      : raster_(raster),
        layers_(layers),
        material_(material),
        found_(layers),
        shown_(raster, split(true), material),
        passages_(raster, split(false), material) {}

  std::vector<Mask> layers() {
    find_ends();
    for_each_in_passages([&](std::size_t layer, std::size_t column, std::size_t row) {
      Touched& touched = touched_[passages_.at(layer, column, row)];
      for_neighbours(layer, column, row, [&](std::size_t l, std::size_t c, std::size_t r) {
        if (!is(l, raster_.index(c, r)) || !covered(raster_.index(c, r))) return;
        const std::uint32_t part = shown_.at(l, c, r);
        touched.parts.insert(part);
        touched.end = touched.end || in_lower_.contains(part) != in_upper_.contains(part);
      });
    });
    for_each_in_passages([&](std::size_t layer, std::size_t column, std::size_t row) {
      const Touched& touched = touched_[passages_.at(layer, column, row)];
      if (!touched.end && touched.parts.size() > 1) found_[layer][raster_.index(column, row)] = material_ ? 0 : 1;
    });
    return std::move(found_);
  }

 private:
  struct Touched {
    std::set<std::uint32_t> parts;
    bool end = false;  // one of them lies in one of the two slices alone
  };

  bool is(std::size_t layer, std::size_t p) const { return (layers_[layer][p] != 0) == material_; }
  bool covered(std::size_t p) const { return is(0, p) || is(layers_.size() - 1, p); }

  std::vector<Mask> split(bool covered_ones) const {
    std::vector<Mask> result(layers_.size(), Mask(raster_.size(), material_ ? 0 : 1));
    for (std::size_t layer = 0; layer < layers_.size(); ++layer)
      for (std::size_t p = 0; p < raster_.size(); ++p)
        if (is(layer, p) && covered(p) == covered_ones) result[layer][p] = material_ ? 1 : 0;
    return result;
  }

  void find_ends() {
    for (const auto& part : shown_.parts(0)) in_lower_.insert(part.component);
    for (const auto& part : shown_.parts(layers_.size() - 1)) in_upper_.insert(part.component);
  }

  template <class Visit>
  void for_each_in_passages(const Visit& visit) {
    for (std::size_t layer = 1; layer + 1 < layers_.size(); ++layer)
      for (std::size_t row = 0; row < raster_.rows; ++row)
        for (std::size_t column = 0; column < raster_.columns; ++column)
          if (is(layer, raster_.index(column, row)) && !covered(raster_.index(column, row))) visit(layer, column, row);
  }

  /// By faces, and for material by corners too.
  template <class Visit>
  void for_neighbours(std::size_t layer, std::size_t column, std::size_t row, const Visit& visit) const {
    for (int dl = -1; dl <= 1; ++dl)
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc) {
          if (!material_ && std::abs(dl) + std::abs(dr) + std::abs(dc) > 1) continue;
          const std::size_t l = layer + static_cast<std::size_t>(dl), r = row + static_cast<std::size_t>(dr),
                            c = column + static_cast<std::size_t>(dc);  // -1 wraps round, and is too large
          if (l < layers_.size() && r < raster_.rows && c < raster_.columns) visit(l, c, r);
        }
  }

  const Raster& raster_;
  const std::vector<Mask>& layers_;
  bool material_;
  std::vector<Mask> found_;
  Components shown_, passages_;
  std::set<std::uint32_t> in_lower_, in_upper_;
  std::map<std::uint32_t, Touched> touched_;
};

/// The whole solid, put together slab by slab.
class Simplest {
 public:
  explicit Simplest(std::vector<Section> sections)
      : sections_(number(std::move(sections))), pieces_(materials_), voids_(all_voids_) {
    for (std::size_t i = 1; i + 1 < sections_.size(); ++i) euler_ -= sections_[i].euler();
    for (const Section& section : sections_) voids_.join(sections_.front().first_void, section.first_void);
    for (const Section* end : {&sections_.front(), &sections_.back()})  // beyond the ends of the stack nothing goes on
      for (std::uint32_t i = 0; i < end->material.size(); ++i) end_flat(*end, i, voids_, end->first_void);
  }

  /// `over`: pairs of regions of material, as places in their sections, that lie partly over each other.
  void add_slab(std::size_t slab, const std::vector<Joined>& material, const std::vector<Joined>& voids,
                const Pairs& over) {
    const Section &lower = sections_[slab], &upper = sections_[slab + 1];
    const auto lower_voids = static_cast<std::uint32_t>(lower.voids.size());
    UnionFind own(lower.voids.size() + upper.voids.size());
    own.join(0, lower_voids);
    long pieces = 0;
    for (const Joined& piece : material) {
      if (!piece.both()) {
        pieces += static_cast<long>(piece.lower.size() + piece.upper.size());
        for (const std::uint32_t i : piece.lower) end_flat(lower, i, own, 0);
        for (const std::uint32_t i : piece.upper) end_flat(upper, i, own, lower_voids);
        continue;
      }
      ++pieces;
      most_cycles_ += cycles_of(piece, over);
      for (const std::uint32_t i : piece.lower)
        pieces_.join(lower.first_material + piece.lower[0], lower.first_material + i);
      for (const std::uint32_t i : piece.upper)
        pieces_.join(lower.first_material + piece.lower[0], upper.first_material + i);
    }
    for (const Joined& of : voids) {
      if (!of.both()) continue;
      for (const std::uint32_t i : of.lower) own.join(of.lower[0], i);
      for (const std::uint32_t i : of.upper) own.join(of.lower[0], lower_voids + i);
    }
    long blind = 0;
    const auto whole = [&](std::uint32_t i) {
      return i < lower_voids ? lower.first_void + i : upper.first_void + i - lower_voids;
    };
    for (std::uint32_t i = 0; i < lower.voids.size() + upper.voids.size(); ++i) {
      blind += own.find(i) == i && own.find(0) != i;
      voids_.join(whole(i), whole(own.find(i)));
    }
    euler_ += pieces - (lower.holes() + upper.holes() - blind);
  }

  bool allows(const Topology& truth) {
    Topology found{count(pieces_, materials_), 0, count(voids_, all_voids_) - 1};
    found.handles = found.pieces + found.bubbles - euler_;
    return truth.pieces == found.pieces && truth.bubbles == found.bubbles && truth.handles >= found.handles &&
           truth.handles <= found.handles + most_cycles_;
  }

  const Section& section(std::size_t i) const { return sections_[i]; }

 private:
  std::vector<Section> number(std::vector<Section> sections) {
    for (Section& section : sections) {
      section.first_material = materials_;
      section.first_void = all_voids_;
      materials_ += static_cast<std::uint32_t>(section.material.size());
      all_voids_ += static_cast<std::uint32_t>(section.voids.size());
    }
    return sections;
  }

  /// Loops that links between regions that lie over each other can make; those that do not only make it whole.
  static long cycles_of(const Joined& piece, const Pairs& over) {
    UnionFind sets(piece.lower.size() + piece.upper.size());
    long cycles = 0;
    for (std::uint32_t i = 0; i < piece.lower.size(); ++i)
      for (std::uint32_t j = 0; j < piece.upper.size(); ++j) {
        const auto upper = static_cast<std::uint32_t>(piece.lower.size()) + j;
        if (!over.contains({piece.lower[i], piece.upper[j]})) continue;
        cycles += sets.find(i) == sets.find(upper);
        sets.join(i, upper);
      }
    return cycles;
  }

  /// Around a region that ends on its slice all voids beside it are one.
  static void end_flat(const Section& section, std::uint32_t region, UnionFind& voids, std::uint32_t first) {
    for (const std::uint32_t i : section.beside[region]) voids.join(first + section.beside[region][0], first + i);
  }

  static long count(UnionFind& sets, std::uint32_t things) {
    long groups = 0;
    for (std::uint32_t i = 0; i < things; ++i) groups += sets.find(i) == i;
    return groups;
  }

  std::uint32_t materials_ = 0, all_voids_ = 0;
  std::vector<Section> sections_;
  UnionFind pieces_, voids_;
  long euler_ = 0, most_cycles_ = 0;
};

Mask only(const Mask& mask, std::size_t structure) {
  Mask own(mask.size());
  std::transform(mask.begin(), mask.end(), own.begin(),
                 [structure](std::uint8_t bits) { return static_cast<std::uint8_t>(bits >> structure & 1); });
  return own;
}

}  // namespace

bool visible(const Raster& raster, const std::vector<std::vector<Mask>>& slabs, const Topology& truth) {
  std::vector<Section> sections{section_of(raster, slabs.front().front())};
  for (const std::vector<Mask>& layers : slabs) sections.push_back(section_of(raster, layers.back()));
  Simplest solid(std::move(sections));
  for (std::size_t slab = 0; slab < slabs.size(); ++slab) {
    const std::vector<Mask>& layers = slabs[slab];
    const Section &lower = solid.section(slab), &upper = solid.section(slab + 1);
    const auto links = [&](bool material, const auto& below, const auto& above) {
      const std::vector<Mask> shown = ShownPassages(raster, layers, material).layers();
      return joined(Components(raster, shown, material), layers.size() - 1, below, above);
    };
    solid.add_slab(slab, links(true, lower.material, upper.material), links(false, lower.voids, upper.voids),
                   over_each_other(raster, layers.front(), layers.back()));
  }
  return solid.allows(truth);
}

std::vector<bool> visible(const ContourStack& stack, const Truth& truth) {
  std::vector<double> heights;
  std::vector<std::size_t> first{0};  // of each slab, and one more
  for (std::size_t slab = 0; slab + 1 < stack.slices.size(); ++slab) {
    const double low = stack.slices[slab].z, high = stack.slices[slab + 1].z;
    const int steps = std::max(2, static_cast<int>(std::ceil((high - low) / truth.raster.step - 1e-9)));
    for (int i = 1; i < steps; ++i) heights.push_back(low + (high - low) * i / steps);
    first.push_back(heights.size());
  }
  const std::vector<Mask> between = truth.masks(heights);
  std::vector<bool> result;
  for (std::size_t s = 0; s < truth.names.size(); ++s) {
    std::vector<std::vector<Mask>> slabs;
    for (std::size_t slab = 0; slab + 1 < stack.slices.size(); ++slab) {
      std::vector<Mask> layers{inside_contours(truth.raster, stack.slices[slab], truth.names[s])};
      for (std::size_t i = first[slab]; i < first[slab + 1]; ++i) layers.push_back(only(between[i], s));
      layers.push_back(inside_contours(truth.raster, stack.slices[slab + 1], truth.names[s]));
      slabs.push_back(std::move(layers));
    }
    result.push_back(visible(truth.raster, slabs, truth.topology[s]));
  }
  return result;
}

}  // namespace odontoscope::test
