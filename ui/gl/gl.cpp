#include "ui/gl/gl.h"

namespace asos::ui::gl {

PFNGLACTIVETEXTUREPROC glActiveTexture = nullptr;
PFNGLATTACHSHADERPROC glAttachShader = nullptr;
PFNGLBINDBUFFERPROC glBindBuffer = nullptr;
PFNGLBINDSAMPLERPROC glBindSampler = nullptr;
PFNGLBINDTEXTUREPROC glBindTexture = nullptr;
PFNGLBINDVERTEXARRAYPROC glBindVertexArray = nullptr;
PFNGLBLENDEQUATIONPROC glBlendEquation = nullptr;
PFNGLBLENDEQUATIONSEPARATEPROC glBlendEquationSeparate = nullptr;
PFNGLBLENDFUNCSEPARATEPROC glBlendFuncSeparate = nullptr;
PFNGLBUFFERDATAPROC glBufferData = nullptr;
PFNGLBUFFERSUBDATAPROC glBufferSubData = nullptr;
PFNGLCLEARPROC glClear = nullptr;
PFNGLCLEARCOLORPROC glClearColor = nullptr;
PFNGLCOMPILESHADERPROC glCompileShader = nullptr;
PFNGLCREATEPROGRAMPROC glCreateProgram = nullptr;
PFNGLCREATESHADERPROC glCreateShader = nullptr;
PFNGLDELETEBUFFERSPROC glDeleteBuffers = nullptr;
PFNGLDELETEPROGRAMPROC glDeleteProgram = nullptr;
PFNGLDELETESHADERPROC glDeleteShader = nullptr;
PFNGLDELETETEXTURESPROC glDeleteTextures = nullptr;
PFNGLDELETEVERTEXARRAYSPROC glDeleteVertexArrays = nullptr;
PFNGLDETACHSHADERPROC glDetachShader = nullptr;
PFNGLDISABLEPROC glDisable = nullptr;
PFNGLDRAWARRAYSPROC glDrawArrays = nullptr;
PFNGLDRAWELEMENTSPROC glDrawElements = nullptr;
PFNGLDRAWELEMENTSBASEVERTEXPROC glDrawElementsBaseVertex = nullptr;
PFNGLENABLEPROC glEnable = nullptr;
PFNGLENABLEVERTEXATTRIBARRAYPROC glEnableVertexAttribArray = nullptr;
PFNGLFINISHPROC glFinish = nullptr;
PFNGLGENBUFFERSPROC glGenBuffers = nullptr;
PFNGLGENTEXTURESPROC glGenTextures = nullptr;
PFNGLGENVERTEXARRAYSPROC glGenVertexArrays = nullptr;
PFNGLGETATTRIBLOCATIONPROC glGetAttribLocation = nullptr;
PFNGLGETERRORPROC glGetError = nullptr;
PFNGLGETINTEGERVPROC glGetIntegerv = nullptr;
PFNGLGETPROGRAMINFOLOGPROC glGetProgramInfoLog = nullptr;
PFNGLGETPROGRAMIVPROC glGetProgramiv = nullptr;
PFNGLGETSHADERINFOLOGPROC glGetShaderInfoLog = nullptr;
PFNGLGETSHADERIVPROC glGetShaderiv = nullptr;
PFNGLGETSTRINGPROC glGetString = nullptr;
PFNGLGETSTRINGIPROC glGetStringi = nullptr;
PFNGLGETUNIFORMLOCATIONPROC glGetUniformLocation = nullptr;
PFNGLISENABLEDPROC glIsEnabled = nullptr;
PFNGLLINKPROGRAMPROC glLinkProgram = nullptr;
PFNGLPIXELSTOREIPROC glPixelStorei = nullptr;
PFNGLPOLYGONMODEPROC glPolygonMode = nullptr;
PFNGLREADPIXELSPROC glReadPixels = nullptr;
PFNGLSCISSORPROC glScissor = nullptr;
PFNGLSHADERSOURCEPROC glShaderSource = nullptr;
PFNGLTEXIMAGE2DPROC glTexImage2D = nullptr;
PFNGLTEXPARAMETERIPROC glTexParameteri = nullptr;
PFNGLTEXSUBIMAGE2DPROC glTexSubImage2D = nullptr;
PFNGLUNIFORM1FPROC glUniform1f = nullptr;
PFNGLUNIFORM1IPROC glUniform1i = nullptr;
PFNGLUNIFORM4FPROC glUniform4f = nullptr;
PFNGLUNIFORMMATRIX4FVPROC glUniformMatrix4fv = nullptr;
PFNGLUSEPROGRAMPROC glUseProgram = nullptr;
PFNGLVERTEXATTRIBPOINTERPROC glVertexAttribPointer = nullptr;
PFNGLVIEWPORTPROC glViewport = nullptr;

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

void load_all(Loader& loader) {
  loader.load(glActiveTexture, "glActiveTexture");
  loader.load(glAttachShader, "glAttachShader");
  loader.load(glBindBuffer, "glBindBuffer");
  loader.load(glBindSampler, "glBindSampler");
  loader.load(glBindTexture, "glBindTexture");
  loader.load(glBindVertexArray, "glBindVertexArray");
  loader.load(glBlendEquation, "glBlendEquation");
  loader.load(glBlendEquationSeparate, "glBlendEquationSeparate");
  loader.load(glBlendFuncSeparate, "glBlendFuncSeparate");
  loader.load(glBufferData, "glBufferData");
  loader.load(glBufferSubData, "glBufferSubData");
  loader.load(glClear, "glClear");
  loader.load(glClearColor, "glClearColor");
  loader.load(glCompileShader, "glCompileShader");
  loader.load(glCreateProgram, "glCreateProgram");
  loader.load(glCreateShader, "glCreateShader");
  loader.load(glDeleteBuffers, "glDeleteBuffers");
  loader.load(glDeleteProgram, "glDeleteProgram");
  loader.load(glDeleteShader, "glDeleteShader");
  loader.load(glDeleteTextures, "glDeleteTextures");
  loader.load(glDeleteVertexArrays, "glDeleteVertexArrays");
  loader.load(glDetachShader, "glDetachShader");
  loader.load(glDisable, "glDisable");
  loader.load(glDrawArrays, "glDrawArrays");
  loader.load(glDrawElements, "glDrawElements");
  loader.load(glDrawElementsBaseVertex, "glDrawElementsBaseVertex");
  loader.load(glEnable, "glEnable");
  loader.load(glEnableVertexAttribArray, "glEnableVertexAttribArray");
  loader.load(glFinish, "glFinish");
  loader.load(glGenBuffers, "glGenBuffers");
  loader.load(glGenTextures, "glGenTextures");
  loader.load(glGenVertexArrays, "glGenVertexArrays");
  loader.load(glGetAttribLocation, "glGetAttribLocation");
  loader.load(glGetError, "glGetError");
  loader.load(glGetIntegerv, "glGetIntegerv");
  loader.load(glGetProgramInfoLog, "glGetProgramInfoLog");
  loader.load(glGetProgramiv, "glGetProgramiv");
  loader.load(glGetShaderInfoLog, "glGetShaderInfoLog");
  loader.load(glGetShaderiv, "glGetShaderiv");
  loader.load(glGetString, "glGetString");
  loader.load(glGetStringi, "glGetStringi");
  loader.load(glGetUniformLocation, "glGetUniformLocation");
  loader.load(glIsEnabled, "glIsEnabled");
  loader.load(glLinkProgram, "glLinkProgram");
  loader.load(glPixelStorei, "glPixelStorei");
  loader.load(glPolygonMode, "glPolygonMode");
  loader.load(glReadPixels, "glReadPixels");
  loader.load(glScissor, "glScissor");
  loader.load(glShaderSource, "glShaderSource");
  loader.load(glTexImage2D, "glTexImage2D");
  loader.load(glTexParameteri, "glTexParameteri");
  loader.load(glTexSubImage2D, "glTexSubImage2D");
  loader.load(glUniform1f, "glUniform1f");
  loader.load(glUniform1i, "glUniform1i");
  loader.load(glUniform4f, "glUniform4f");
  loader.load(glUniformMatrix4fv, "glUniformMatrix4fv");
  loader.load(glUseProgram, "glUseProgram");
  loader.load(glVertexAttribPointer, "glVertexAttribPointer");
  loader.load(glViewport, "glViewport");
}

}  // namespace

Result<void> load(GetFunction get) {
  Loader loader{get};
  load_all(loader);
  if (loader.missing) {
    return unexpected(Error{
        "OpenGL", std::string("the driver lacks ") + loader.missing + "; OpenGL 3.3 is needed"});
  }
  return {};
}

}  // namespace asos::ui::gl
