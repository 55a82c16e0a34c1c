#pragma once
// Eigenvectors of a symmetric matrix of three rows.

#include <array>

namespace odontoscope {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// By Jacobi's rotations (Golub and Van Loan, Matrix Computations, 8.5): `matrix`, which must be symmetric, becomes
/// diagonal; the columns of what is returned are its eigenvectors, unit vectors in no order.
Matrix3 eigenvectors(Matrix3& matrix);

}  // namespace odontoscope
