#pragma once
// Numbers that count things of one kind: a point of a slice is no tetrahedron of a slab, and the compiler says so.
//
// An index is made from a number in so many words only, and gives it back by itself. Tables take indices of their own
// kind alone.

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace odontoscope {

/// The index of nothing, whatever the kind.
struct NoIndex {
  constexpr operator std::uint32_t() const { return 0xffffffffu; }
};

/// `Kind` is a tag that nobody defines.
template <class Kind>
class Index {
 public:
  constexpr Index() = default;
  constexpr Index(NoIndex) {}
  template <std::integral Number>
  constexpr explicit Index(Number number) : number_(static_cast<std::uint32_t>(number)) {}
  /// From one kind to another: where both count the same things by the same numbers.
  template <class Other>
  constexpr explicit Index(Index<Other> other) : number_(other) {}

  constexpr operator std::uint32_t() const { return number_; }
  constexpr Index& operator++() {
    ++number_;
    return *this;
  }

  friend constexpr bool operator==(Index a, Index b) { return a.number_ == b.number_; }
  friend constexpr bool operator==(Index a, NoIndex) { return a.number_ == NoIndex(); }
  friend constexpr auto operator<=>(Index a, Index b) { return a.number_ <=> b.number_; }

 private:
  std::uint32_t number_ = NoIndex();
};

template <class A, class B>
requires(!std::same_as<A, B>) bool operator==(Index<A>, Index<B>) = delete;
template <class A, class B>
requires(!std::same_as<A, B>) auto operator<=>(Index<A>, Index<B>) = delete;

/// The indices from one to before another.
template <class I>
class Indices {
 public:
  Indices(I first, I end) : first_(first), end_(end) {}

  struct Iterator {
    I at;
    I operator*() const { return at; }
    Iterator& operator++() {
      ++at;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  Iterator begin() const { return {first_}; }
  Iterator end() const { return {end_}; }
  /// Precondition of both: there is one.
  I front() const { return first_; }
  I back() const { return I(end_ - 1); }

 private:
  I first_, end_;
};

/// A vector that is indexed by its own kind alone.
template <class I, class T>
class Table : public std::vector<T> {
 public:
  using std::vector<T>::vector;
  Table() = default;
  explicit Table(std::vector<T> values) : std::vector<T>(std::move(values)) {}

  decltype(auto) operator[](I i) { return std::vector<T>::operator[](i); }
  decltype(auto) operator[](I i) const { return std::vector<T>::operator[](i); }

  Indices<I> indices() const { return {I(0), I(this->size())}; }
};

}  // namespace odontoscope

template <class Kind>
struct std::hash<odontoscope::Index<Kind>> {
  std::size_t operator()(odontoscope::Index<Kind> index) const { return std::hash<std::uint32_t>()(index); }
};
