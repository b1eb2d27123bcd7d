#pragma once

#include "renderer/result.h"

#include <GL/glcorearb.h>

// A table of OpenGL 3.3 core functions, used with a window (GLFW) and with a context in memory
// (OSMesa): no other loader serves both. The names live in a namespace, because global variables of
// the same names would replace libGL's functions at link time.

namespace asos::ui::gl {

using Function = void (*)();
using GetFunction = Function (*)(const char* name);

/// Fills the table for the context that is current on the calling thread. The error names a missing
/// function. All calls through the table must be made on that thread.
[[nodiscard]] Result<void> load(GetFunction get);

/// Calls FUNCTION(NAME, Name) for each function glName of the table.
#define ASOS_GL_FUNCTIONS(FUNCTION)                          \
  FUNCTION(ACTIVETEXTURE, ActiveTexture)                     \
  FUNCTION(ATTACHSHADER, AttachShader)                       \
  FUNCTION(BINDBUFFER, BindBuffer)                           \
  FUNCTION(BINDSAMPLER, BindSampler)                         \
  FUNCTION(BINDTEXTURE, BindTexture)                         \
  FUNCTION(BINDVERTEXARRAY, BindVertexArray)                 \
  FUNCTION(BLENDEQUATION, BlendEquation)                     \
  FUNCTION(BLENDEQUATIONSEPARATE, BlendEquationSeparate)     \
  FUNCTION(BLENDFUNCSEPARATE, BlendFuncSeparate)             \
  FUNCTION(BUFFERDATA, BufferData)                           \
  FUNCTION(BUFFERSUBDATA, BufferSubData)                     \
  FUNCTION(CLEAR, Clear)                                     \
  FUNCTION(CLEARCOLOR, ClearColor)                           \
  FUNCTION(COMPILESHADER, CompileShader)                     \
  FUNCTION(CREATEPROGRAM, CreateProgram)                     \
  FUNCTION(CREATESHADER, CreateShader)                       \
  FUNCTION(DELETEBUFFERS, DeleteBuffers)                     \
  FUNCTION(DELETEPROGRAM, DeleteProgram)                     \
  FUNCTION(DELETESHADER, DeleteShader)                       \
  FUNCTION(DELETETEXTURES, DeleteTextures)                   \
  FUNCTION(DELETEVERTEXARRAYS, DeleteVertexArrays)           \
  FUNCTION(DETACHSHADER, DetachShader)                       \
  FUNCTION(DISABLE, Disable)                                 \
  FUNCTION(DRAWARRAYS, DrawArrays)                           \
  FUNCTION(DRAWELEMENTS, DrawElements)                       \
  FUNCTION(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex)   \
  FUNCTION(ENABLE, Enable)                                   \
  FUNCTION(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
  FUNCTION(FINISH, Finish)                                   \
  FUNCTION(GENBUFFERS, GenBuffers)                           \
  FUNCTION(GENTEXTURES, GenTextures)                         \
  FUNCTION(GENVERTEXARRAYS, GenVertexArrays)                 \
  FUNCTION(GETATTRIBLOCATION, GetAttribLocation)             \
  FUNCTION(GETERROR, GetError)                               \
  FUNCTION(GETINTEGERV, GetIntegerv)                         \
  FUNCTION(GETPROGRAMINFOLOG, GetProgramInfoLog)             \
  FUNCTION(GETPROGRAMIV, GetProgramiv)                       \
  FUNCTION(GETSHADERINFOLOG, GetShaderInfoLog)               \
  FUNCTION(GETSHADERIV, GetShaderiv)                         \
  FUNCTION(GETSTRING, GetString)                             \
  FUNCTION(GETSTRINGI, GetStringi)                           \
  FUNCTION(GETUNIFORMLOCATION, GetUniformLocation)           \
  FUNCTION(ISENABLED, IsEnabled)                             \
  FUNCTION(LINKPROGRAM, LinkProgram)                         \
  FUNCTION(PIXELSTOREI, PixelStorei)                         \
  FUNCTION(POLYGONMODE, PolygonMode)                         \
  FUNCTION(READPIXELS, ReadPixels)                           \
  FUNCTION(SCISSOR, Scissor)                                 \
  FUNCTION(SHADERSOURCE, ShaderSource)                       \
  FUNCTION(TEXIMAGE2D, TexImage2D)                           \
  FUNCTION(TEXPARAMETERI, TexParameteri)                     \
  FUNCTION(TEXSUBIMAGE2D, TexSubImage2D)                     \
  FUNCTION(UNIFORM1F, Uniform1f)                             \
  FUNCTION(UNIFORM1I, Uniform1i)                             \
  FUNCTION(UNIFORM4F, Uniform4f)                             \
  FUNCTION(UNIFORMMATRIX4FV, UniformMatrix4fv)               \
  FUNCTION(USEPROGRAM, UseProgram)                           \
  FUNCTION(VERTEXATTRIBPOINTER, VertexAttribPointer)         \
  FUNCTION(VIEWPORT, Viewport)

#define ASOS_GL_DECLARE(NAME, Name) extern PFNGL##NAME##PROC gl##Name;
ASOS_GL_FUNCTIONS(ASOS_GL_DECLARE)
#undef ASOS_GL_DECLARE

}  // namespace asos::ui::gl
