#pragma once

// Included before Dear ImGui's OpenGL 3 backend, so that its unqualified calls use our table.

#include "ui/gl/gl.h"

using namespace asos::ui::gl;
