#pragma once

// Included ahead of Dear ImGui's OpenGL 3 backend: lets its unqualified calls find our table.

#include "ui/gl/gl.h"

using namespace asos::ui::gl;
