#include "ui/gl/gl.h"

namespace asos::ui::gl {

#define ASOS_GL_DEFINE(NAME, Name) PFNGL##NAME##PROC gl##Name = nullptr;
ASOS_GL_FUNCTIONS(ASOS_GL_DEFINE)
#undef ASOS_GL_DEFINE

namespace {

struct Loader {
  GetFunction get;
  const char* missing = nullptr;

  template <typename Pointer>
  void load(Pointer& pointer, const char* name) {
    pointer = reinterpret_cast<Pointer>(get(name));
    if (!pointer && !missing) missing = name;
  }
};

}  // namespace

Result<void> load(GetFunction get) {
  Loader loader{get};
#define ASOS_GL_LOAD(NAME, Name) loader.load(gl##Name, "gl" #Name);
  ASOS_GL_FUNCTIONS(ASOS_GL_LOAD)
#undef ASOS_GL_LOAD
  if (loader.missing) {
    return unexpected(Error{
        "OpenGL", std::string("the driver lacks ") + loader.missing + "; OpenGL 3.3 is needed"});
  }
  return {};
}

}  // namespace asos::ui::gl
