#include "tests/ui/osmesa_context.h"

#include "ui/gl/gl.h"

// This header declares all of OpenGL's functions, so it is included only here.
#include <GL/osmesa.h>
#include <cstddef>
#include <vector>

namespace asos::test {
using namespace ui;

struct OsmesaContext::Impl {
  OSMesaContext context = nullptr;
  std::vector<unsigned char> pixels;
};

OsmesaContext::OsmesaContext() : impl_(std::make_unique<Impl>()) {}

Result<std::unique_ptr<OsmesaContext>> OsmesaContext::make(int width, int height) {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  std::unique_ptr<OsmesaContext> made(new OsmesaContext);
  made->impl_->context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!made->impl_->context) return unexpected(Error{"OSMesa", "no context"});
  if (!made->resize(width, height)) return unexpected(Error{"OSMesa", "context not current"});
  const auto get = [](const char* name) { return OSMesaGetProcAddress(name); };
  if (const Result<void> loaded = gl::load(get); !loaded) return unexpected(loaded.error());
  return made;
}

OsmesaContext::~OsmesaContext() {
  if (impl_->context) OSMesaDestroyContext(impl_->context);
}

bool OsmesaContext::resize(int width, int height) {
  std::vector<unsigned char> pixels(static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height) * 4);
  const bool current =
      OSMesaMakeCurrent(impl_->context, pixels.data(), GL_UNSIGNED_BYTE, width, height) == GL_TRUE;
  if (current) impl_->pixels = std::move(pixels);
  return current;
}

}  // namespace asos::test
