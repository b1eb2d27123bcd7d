#pragma once

#include "renderer/rays/filters.h"

#include <embree3/rtcore.h>

namespace asos::tracing {

/// Sets `geometry`, one of Embree's user geometries, to the faces of analytic shapes in `group`,
/// which must not be moved. The caller sets the filters.
void set_faces(RTCGeometry geometry, Group& group);

}  // namespace asos::tracing
