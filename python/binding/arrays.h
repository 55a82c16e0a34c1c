#pragma once
// Arrays of the library as numpy arrays, and the other way round.
//
// Out: a view, never a copy. It is read-only, since what it shows was certified as it is, and it keeps its owner alive.
// In: always a copy, so that whatever becomes of the caller's array later changes nothing here.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace odontoscope::python {

namespace py = pybind11;

/// Keeps `owner` alive as long as Python refers to it.
inline py::capsule kept(std::shared_ptr<const void> owner) {
  auto held = std::make_unique<std::shared_ptr<const void>>(std::move(owner));
  py::capsule capsule(held.get(), [](void* p) { delete static_cast<std::shared_ptr<const void>*>(p); });
  held.release();
  return capsule;
}

inline py::array read_only(py::array array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// Items of N scalars each, as an array of shape (items, N).
template <class Scalar, std::size_t N, class Item>
py::array table_view(const std::vector<Item>& items, const std::shared_ptr<const void>& owner) {
  static_assert(sizeof(Item) == N * sizeof(Scalar), "the scalars lie side by side");
  const auto step = static_cast<py::ssize_t>(sizeof(Scalar));
  return read_only(py::array(py::dtype::of<Scalar>(),
                             {static_cast<py::ssize_t>(items.size()), static_cast<py::ssize_t>(N)},
                             {static_cast<py::ssize_t>(N) * step, step}, items.data(), kept(owner)));
}

/// N scalars of each item, `offset` bytes into it, as an array of shape (items, N): the items' other bytes are stepped
/// over.
template <class Scalar, std::size_t N, class Item>
py::array member_view(const std::vector<Item>& items, std::size_t offset, const std::shared_ptr<const void>& owner) {
  static_assert(sizeof(Item) >= N * sizeof(Scalar));
  return read_only(py::array(py::dtype::of<Scalar>(),
                             {static_cast<py::ssize_t>(items.size()), static_cast<py::ssize_t>(N)},
                             {static_cast<py::ssize_t>(sizeof(Item)), static_cast<py::ssize_t>(sizeof(Scalar))},
                             reinterpret_cast<const char*>(items.data()) + offset, kept(owner)));
}

/// Scalars as an array of one dimension.
template <class Scalar>
py::array list_view(const std::vector<Scalar>& items, const std::shared_ptr<const void>& owner) {
  return read_only(py::array(py::dtype::of<Scalar>(), {static_cast<py::ssize_t>(items.size())},
                             {static_cast<py::ssize_t>(sizeof(Scalar))}, items.data(), kept(owner)));
}

}  // namespace odontoscope::python
