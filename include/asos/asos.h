#pragma once

/// All of the public interface.
#include "asos/error.h"
#include "asos/picture.h"
#include "asos/render.h"
#include "asos/scene.h"
#include "asos/session.h"
#include "asos/settings.h"
#include "asos/trace.h"
#include "asos/types.h"

namespace asos::api {

/// Returns the version of the library, as "1.0.0". Any thread.
[[nodiscard]] ASOS_API const char* version() noexcept;

}  // namespace asos::api
