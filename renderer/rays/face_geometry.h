#pragma once

#include "renderer/rays/filters.h"

#include <embree3/rtcore.h>

namespace asos::tracing {

/// Makes `geometry`, one of Embree's user geometries, that of the faces of analytic shapes which
/// `group` lists; the group must stay where it is. Filters have to be set by the caller.
void set_faces(RTCGeometry geometry, Group& group);

}  // namespace asos::tracing
