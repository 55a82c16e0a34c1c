#include "engine/scene/fit_visible.h"

#include <algorithm>

namespace odontoscope {

namespace {

/// The vertices that are left, which are all that a fit looks at.
Model without(const std::vector<std::string>& hidden, const Model& model) {
  Model left;
  left.origin_mm = model.origin_mm;
  left.bounds_mm = model.bounds_mm;
  left.radius_mm = model.radius_mm;
  for (const ModelPart& part : model.parts) {
    if (std::find(hidden.begin(), hidden.end(), part.structure) != hidden.end()) continue;
    ModelPart& kept = left.parts.emplace_back();
    kept.structure = part.structure;
    kept.positions = part.positions;
  }
  return left;
}

template <class How>
Camera fitted(const std::vector<std::string>& hidden, const How& how, const Model& model) {
  if (hidden.empty()) return how(model);
  const Model left = without(hidden, model);
  return how(left.parts.empty() ? model : left);
}

}  // namespace

Camera fit_without(const std::vector<std::string>& hidden, const Camera& looking, const Model& model, double aspect) {
  return fitted(
      hidden, [&](const Model& seen) { return fit(looking, seen, aspect); }, model);
}

Camera fit_without(const std::vector<std::string>& hidden, NamedView view, const Model& model, double aspect,
                   Camera::Projection projection) {
  return fitted(
      hidden, [&](const Model& seen) { return fit(view, seen, aspect, projection); }, model);
}

std::vector<std::string> hidden_in(const Scene& scene) {
  std::vector<std::string> hidden;
  for (const Look& look : scene.looks)
    if (!look.visible) hidden.push_back(look.structure);
  return hidden;
}

}  // namespace odontoscope
