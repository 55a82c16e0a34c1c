// OpenGL drawn by the processor into memory: Mesa's OSMesa, which needs neither a display nor a device.

#include <fmt/format.h>

#include <array>

#include "engine/gpu/context.h"
#include "engine/gpu/dynamic_library.h"

// The loader's header stands in for GL/gl.h, which osmesa.h includes; these are the only macros of it that osmesa.h
// needs.
#ifndef GLAPI
#define GLAPI extern
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif
#include <GL/osmesa.h>

namespace odontoscope {

namespace {

constexpr const char* install_osmesa = "Install OSMesa (Debian: libosmesa6).";

struct OSMesaLibrary {
  DynamicLibrary library{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
  decltype(&OSMesaCreateContextAttribs) create =
      library.function<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
  decltype(&OSMesaDestroyContext) destroy = library.function<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
  decltype(&OSMesaMakeCurrent) make_current = library.function<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  decltype(&OSMesaGetProcAddress) get_proc_address =
      library.function<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");

  bool complete() const { return create && destroy && make_current && get_proc_address; }
};

class OSMesaGlContext final : public GlContext {
 public:
  explicit OSMesaGlContext(const ContextOptions& options) : GlContext(Backend::osmesa) {
    if (!mesa_.library.is_open())
      throw GraphicsError("no-osmesa", fmt::format("OSMesa cannot be opened ({})", mesa_.library.trouble()),
                          install_osmesa);
    if (!mesa_.complete())
      throw GraphicsError("no-osmesa", "this OSMesa lacks a function that is needed", install_osmesa);
    const std::array<int, 9> wanted = {OSMESA_FORMAT,
                                       OSMESA_RGBA,
                                       OSMESA_PROFILE,
                                       OSMESA_CORE_PROFILE,
                                       OSMESA_CONTEXT_MAJOR_VERSION,
                                       4,
                                       OSMESA_CONTEXT_MINOR_VERSION,
                                       1,
                                       0};
    context_ = mesa_.create(wanted.data(), nullptr);
    if (!context_) throw GraphicsError("gl-too-old", "this OSMesa has no OpenGL 4.1 core", "Install a newer Mesa.");
    try {
      make_current();
      load(
          [](const char* function) {
            return reinterpret_cast<GLADapiproc>(OSMesaLibrary{}.get_proc_address(function));
          },
          options);
    } catch (...) {
      mesa_.destroy(context_);
      throw;
    }
  }

  ~OSMesaGlContext() override { mesa_.destroy(context_); }

  void make_current() override {
    if (!mesa_.make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, side, side))
      throw GraphicsError("no-osmesa", "OSMesa cannot make its context current", install_osmesa);
  }

 private:
  // OSMesa wants a picture of its own; everything here is drawn into framebuffer objects, so a small one will do.
  static constexpr int side = 4;
  std::array<unsigned char, 4 * side * side> pixels_{};
  OSMesaLibrary mesa_;
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context(const ContextOptions& options) {
  return std::make_unique<OSMesaGlContext>(options);
}

}  // namespace odontoscope
