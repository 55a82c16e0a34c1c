#include "engine/gpu/context.h"

#include <fmt/format.h>

#include <cstdlib>

#include "engine/gpu/window_context.h"

namespace odontoscope {

namespace {

constexpr int oldest_version = GLAD_MAKE_VERSION(4, 1);

std::string text(const GLubyte* characters) {
  return characters ? std::string(reinterpret_cast<const char*>(characters)) : std::string("unknown");
}

void GLAD_API_PTR keep_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei, const GLchar* message,
                               const void* list) {
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  static_cast<std::vector<std::string>*>(const_cast<void*>(list))->emplace_back(message);
}

}  // namespace

GraphicsError::GraphicsError(std::string_view cause, std::string_view wrong, std::string_view remedy)
    : Error(ExitCode::graphics, fmt::format("{}. {} [{}]", wrong, remedy, cause), wrong, remedy), cause_(cause) {}

const char* name(Backend backend) {
  switch (backend) {
    case Backend::automatic:
      return "auto";
    case Backend::window:
      return "window";
    case Backend::egl:
      return "egl";
    case Backend::osmesa:
      return "osmesa";
  }
  return "unknown";
}

Backend backend_named(std::string_view wanted) {
  for (const Backend backend : {Backend::automatic, Backend::window, Backend::egl, Backend::osmesa})
    if (wanted == name(backend)) return backend;
  throw UsageError(fmt::format("there is no backend \"{}\"", wanted), "Choose auto, window, egl or osmesa.");
}

void GlContext::load(GLADloadfunc get_function, const ContextOptions& options) {
  const int version = gladLoadGLContext(&gl_, get_function);
  if (version == 0)
    throw GraphicsError("no-gl", "OpenGL's functions cannot be found", "Install a driver, e.g. libgl1-mesa-dri.");
  const std::string renderer = text(gl_.GetString(GL_RENDERER));
  if (version < oldest_version)
    throw GraphicsError(
        "gl-too-old", fmt::format("{} offers OpenGL {}, and 4.1 is needed", renderer, text(gl_.GetString(GL_VERSION))),
        "Update the driver, or draw in software with --backend osmesa.");
  in_words_ = fmt::format("{}, OpenGL {}, {}", name(backend_), text(gl_.GetString(GL_VERSION)), renderer);
  if (!options.debug || !gl_.KHR_debug) return;
  gl_.Enable(GL_DEBUG_OUTPUT);
  gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl_.DebugMessageCallback(keep_message, &debug_messages_);
}

bool names_a_display() {
  const auto is_set = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value;
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

std::unique_ptr<GlContext> make_context(const ContextOptions& options) {
  switch (options.backend) {
    case Backend::window:
      return open_window({.visible = false, .debug = options.debug});
    case Backend::egl:
      return make_egl_context(options);
    case Backend::osmesa:
      return make_osmesa_context(options);
    case Backend::automatic:
      break;
  }
  std::vector<Backend> candidates;
  if (options.window_allowed && names_a_display()) candidates.push_back(Backend::window);
  candidates.insert(candidates.end(), {Backend::egl, Backend::osmesa});
  std::string said;
  for (const Backend candidate : candidates) {
    try {
      return make_context({.backend = candidate, .debug = options.debug});
    } catch (const GraphicsError& error) {
      said += fmt::format(" {}: {}", name(candidate), error.what());
    }
  }
  throw GraphicsError("no-gl", fmt::format("no OpenGL can be had.{}", said), "Any of them is enough.");
}

}  // namespace odontoscope
