#pragma once
// A right-handed frame for parallel planes that lie any way. Inner part of the readers of this room.

#include <array>

namespace odontoscope {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
Vector scaled(const Vector& a, double by);
double length(const Vector& a);

/// Points become (u.p, v.p), heights n.p.
struct Frame {
  Vector u, v, n;
};

/// For planes along an axis the axes themselves, in cyclic order, so that numbers are kept to the bit. For others u is
/// as near to x as the planes allow, or to y where their normal is near to x. Precondition: length 1.
Frame frame_of(const Vector& unit_normal);

}  // namespace odontoscope
