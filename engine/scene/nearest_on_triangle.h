#pragma once
// The point of a triangle that lies nearest to a place.

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace odontoscope {

inline glm::dvec3 nearest_on_edge(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& place) {
  const glm::dvec3 along = b - a;
  const double squared = glm::dot(along, along);
  return squared > 0 ? a + std::clamp(glm::dot(place - a, along) / squared, 0.0, 1.0) * along : a;
}

/// Also for triangles without area.
inline glm::dvec3 nearest_on_triangle(const std::array<glm::dvec3, 3>& t, const glm::dvec3& place) {
  const auto squared_distance = [&](const glm::dvec3& p) { return glm::dot(p - place, p - place); };
  const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], w = place - t[0];
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), wu = glm::dot(w, u), wv = glm::dot(w, v);
  const double whole = uu * vv - uv * uv, s = vv * wu - uv * wv, r = uu * wv - uv * wu;
  // Errors along the triangle count only squared; a needle's may be large, so its edges are asked too.
  constexpr double needle = 1e-6;
  const bool over = whole > 0 && s >= 0 && r >= 0 && s + r <= whole;
  const glm::dvec3 within = over ? t[0] + (s / whole) * u + (r / whole) * v : t[0];
  if (over && whole > needle * uu * vv) return within;
  glm::dvec3 best = within;
  for (const glm::dvec3& other :
       {nearest_on_edge(t[0], t[1], place), nearest_on_edge(t[1], t[2], place), nearest_on_edge(t[2], t[0], place)})
    if (squared_distance(other) < squared_distance(best)) best = other;
  return best;
}

}  // namespace odontoscope
