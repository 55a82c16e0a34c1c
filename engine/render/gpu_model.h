#pragma once
// A model in the graphics processor's memory. Uploading never compiles a shader.

#include <optional>
#include <string>
#include <vector>

#include "engine/gpu/gl_object.h"
#include "engine/scene/model.h"

namespace odontoscope {

struct GpuPart {
  std::string structure;
  std::string solid;
  GlObject vertex_array, positions, normals, indices;
  GLsizei index_count = 0;
  double box_volume = 0;                     // m^3; caps of larger structures lie under those of smaller ones
  float attenuation = 0;                     // ModelPart::attenuation
  std::optional<GlObject> depths = {};       // ModelPart::depths_mm in steps, if it has any
  std::optional<GlObject> thicknesses = {};  // ModelPart::thicknesses_mm in steps below the thickest, if it has any
  std::optional<GlObject> deviations = {};   // ModelPart::deviations, if it has any

  void draw() const;
};

struct GpuModel {
  std::vector<GpuPart> parts;  // those with at least one triangle
  glm::dvec3 origin_mm{0};
  glm::vec3 low{0}, high{0};  // metres, the model's box
  glm::vec3 centre{0};        // of that box
  float radius = 1;           // metres, around `centre`
};

GpuModel upload(const Gl& gl, const Model& model);
GpuPart upload(const Gl& gl, const ModelPart& part, double depth_step_mm = 1);  // that has at least one triangle

}  // namespace odontoscope
