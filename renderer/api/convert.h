#pragma once

#include "asos/error.h"
#include "asos/types.h"
#include "renderer/geometry/camera.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <exception>
#include <new>
#include <string>
#include <utility>

// Conversions from the public types to the renderer's, and back.

namespace asos::api {

[[nodiscard]] inline Error failure(ErrorCode code, std::string subject, std::string reason) {
  return {code, std::move(subject), std::move(reason)};
}

[[nodiscard]] inline Error failure(ErrorCode code, const asos::Error& error) {
  return {code, error.subject, error.reason};
}

/// Calls `work`. Converts an exception into an error about `subject`.
template <typename Work>
[[nodiscard]] auto guarded(const char* subject, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::out_of_memory, subject, "does not fit into this machine's memory");
  } catch (const std::exception& thrown) {
    return failure(ErrorCode::internal, subject, thrown.what());
  } catch (...) {
    return failure(ErrorCode::internal, subject, "an unknown exception was thrown");
  }
}

[[nodiscard]] inline glm::vec3 vector_of(const Float3& v) {
  return {v[0], v[1], v[2]};
}
[[nodiscard]] inline glm::dvec3 vector_of(const Double3& v) {
  return {v[0], v[1], v[2]};
}
[[nodiscard]] inline Float3 array_of(glm::vec3 v) {
  return {v.x, v.y, v.z};
}
[[nodiscard]] inline Double3 array_of(glm::dvec3 v) {
  return {v.x, v.y, v.z};
}
[[nodiscard]] glm::dmat4 matrix_of(const Matrix4& m);
/// Returns whether all values are finite and the last row is that of an affine matrix.
[[nodiscard]] bool is_affine(const Matrix4& m);

/// Convert between a camera in the author's coordinates and one relative to `origin`. Values are
/// not checked: they may be out of range (validate_camera).
[[nodiscard]] asos::Camera camera_of(const Camera& camera, glm::dvec3 origin);
[[nodiscard]] Camera camera_of(const asos::Camera& camera, glm::dvec3 origin);

/// The light, in the author's coordinates. Fails where it has no direction or size, or a value that
/// is not finite.
[[nodiscard]] Result<asos::Light> light_of(const Light& light);

}  // namespace asos::api
