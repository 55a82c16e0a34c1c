#pragma once
// Where OpenGL comes from. A context is a value that its owner keeps; several may live in one process and on several
// threads, each current on at most one thread at a time. Only a window needs a display.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gpu/gl.h"
#include "engine/gpu/graphics_error.h"

namespace odontoscope {

/// `automatic` takes the first that works of window (where the caller allows one and a display is), egl and osmesa.
enum class Backend { automatic, window, egl, osmesa };

const char* name(Backend backend);
/// "auto", "window", "egl", "osmesa"; throws UsageError for anything else.
Backend backend_named(std::string_view name);

struct ContextOptions {
  Backend backend = Backend::automatic;
  /// Ask the driver to report errors and undefined behaviour (KHR_debug); see GlContext::debug_messages. Slower.
  bool debug = false;
  /// May `automatic` open a (hidden) window? Only on the main thread, since window systems insist on it.
  bool window_allowed = false;
};

class GlContext {
 public:
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes this the calling thread's context. Throws GraphicsError.
  virtual void make_current() = 0;

  const Gl& gl() const { return gl_; }
  Backend backend() const { return backend_; }
  /// "EGL, OpenGL 4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& in_words() const { return in_words_; }
  /// What the driver reported since the context was made, notifications left out; empty without `debug`.
  const std::vector<std::string>& debug_messages() const { return debug_messages_; }

 protected:
  explicit GlContext(Backend backend) : backend_(backend) {}
  /// Fills the function table of the current context, checks that it is at least 4.1 core, and starts debug output.
  void load(GLADloadfunc get_function, const ContextOptions& options);

 private:
  Gl gl_{};
  Backend backend_;
  std::string in_words_;
  std::vector<std::string> debug_messages_;
};

/// Makes a context of at least OpenGL 4.1 core, nothing of it to be seen, and makes it current. Throws GraphicsError;
/// for `automatic` the message tells what every backend said.
std::unique_ptr<GlContext> make_context(const ContextOptions& options = {});

/// Does the environment name a display that a window could open on?
bool names_a_display();

std::unique_ptr<GlContext> make_egl_context(const ContextOptions& options);
std::unique_ptr<GlContext> make_osmesa_context(const ContextOptions& options);

}  // namespace odontoscope
