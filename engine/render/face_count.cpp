#include "engine/render/face_count.h"

#include <algorithm>

#include "engine/render/surface_pass.h"

namespace odontoscope {

namespace {

void draw_all(const FramePlan& plan, const Program& program) {
  program.use();
  set_view(program, plan);
  for (const auto* parts : {&plan.opaque, &plan.translucent})
    for (const DrawnPart& part : *parts) part.part->draw();
}

std::vector<float> read_back(const Gl& gl, PixelSize size) {
  std::vector<float> pixels(2 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size.width, size.height, GL_RG, GL_FLOAT, pixels.data());
  return pixels;
}

/// How far the nearest depths of the pixel and its neighbours lie apart; 1 next to an uncovered pixel.
float spread_around(const FaceCounts& counts, int x, int y) {
  float low = 1, high = 0;
  for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, counts.size.height - 1); ++ny)
    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, counts.size.width - 1); ++nx) {
      const std::size_t at =
          static_cast<std::size_t>(ny) * static_cast<std::size_t>(counts.size.width) + static_cast<std::size_t>(nx);
      const float nearest = std::min(counts.front_depth[at], counts.back_depth[at]);
      low = std::min(low, nearest);
      high = std::max(high, nearest);
    }
  return high - low;
}

bool covered(const FaceCounts& counts, int x, int y) {
  if (x < 0 || y < 0 || x >= counts.size.width || y >= counts.size.height) return false;
  const std::size_t at =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(counts.size.width) + static_cast<std::size_t>(x);
  return counts.front[at] != 0 || counts.back[at] != 0;
}

}  // namespace

FaceCounter::FaceCounter(const Gl& gl, const ShaderLibrary& shaders)
    : gl_(&gl),
      votes_(gl, shaders, {"surface.vert", "face_count.frag"}),
      depths_(gl, shaders, {"surface.vert", "face_count.frag", {}, {"DEPTH"}}) {}

FaceCounts FaceCounter::count(const GpuModel& model, const Scene& scene, const View& view, PixelSize size) const {
  const FramePlan plan = plan_frame(model, scene, view, size, 1);
  const Framebuffer pixels(*gl_, {size, {GL_RG32F}});
  constexpr GLfloat zero[4] = {0, 0, 0, 0};
  constexpr GLfloat one[4] = {1, 1, 1, 1};
  pixels.bind();
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_STENCIL_TEST);
  set_culling(*gl_, BackFaces::show);
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->ClearBufferfv(GL_COLOR, 0, zero);
  draw_all(plan, votes_);
  const std::vector<float> votes = read_back(*gl_, size);
  gl_->BlendEquation(GL_MIN);
  gl_->ClearBufferfv(GL_COLOR, 0, one);
  draw_all(plan, depths_);
  const std::vector<float> depths = read_back(*gl_, size);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->Disable(GL_BLEND);

  FaceCounts counts;
  counts.size = size;
  for (std::size_t at = 0; at < votes.size(); at += 2) {
    counts.front.push_back(static_cast<std::uint32_t>(votes[at]));
    counts.back.push_back(static_cast<std::uint32_t>(votes[at + 1]));
    counts.front_depth.push_back(depths[at]);
    counts.back_depth.push_back(depths[at + 1]);
  }
  return counts;
}

namespace {

bool is_tie(const FaceCounts& counts, int x, int y, std::size_t at) {
  return counts.front[at] == counts.back[at] &&
         counts.front_depth[at] - counts.back_depth[at] <= spread_around(counts, x, y);
}

}  // namespace

bool back_is_nearest(const FaceCounts& counts, int x, int y) {
  const std::size_t at =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(counts.size.width) + static_cast<std::size_t>(x);
  return counts.back_depth[at] < counts.front_depth[at] && !is_tie(counts, x, y, at);
}

FaceVerdict judge(const FaceCounts& counts) {
  FaceVerdict verdict;
  for (int y = 0; y < counts.size.height; ++y)
    for (int x = 0; x < counts.size.width; ++x) {
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(counts.size.width) + static_cast<std::size_t>(x);
      if (!covered(counts, x, y)) continue;
      ++verdict.covered;
      verdict.outline += !covered(counts, x - 1, y) || !covered(counts, x + 1, y) || !covered(counts, x, y - 1) ||
                         !covered(counts, x, y + 1);
      const bool balanced = counts.front[at] == counts.back[at];
      verdict.unbalanced += !balanced;
      if (!(counts.back_depth[at] < counts.front_depth[at])) continue;
      ++verdict.back_nearest;
      verdict.ties += is_tie(counts, x, y, at);
    }
  return verdict;
}

}  // namespace odontoscope
