#include "engine/app/comparison_drawn.h"

#include "engine/figures/comparison_pictures.h"
#include "engine/gpu/context.h"

namespace odontoscope::app {

std::string add_comparison_pictures(Comparison& comparison, Session& session) try {
  const auto context = make_context({.backend = Backend::automatic, .window_allowed = true});
  figures::add_pictures(comparison, context->gl(), session.progress());
  return {};
} catch (const GraphicsError& error) {
  return error.what();
}

}  // namespace odontoscope::app
