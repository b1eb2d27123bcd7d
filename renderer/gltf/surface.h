#pragma once

#include "renderer/gltf/vertices.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// Keeps only triangles whose vertices are all finite, and makes the other vertices finite. Returns
/// the number of dropped triangles.
std::size_t drop_infinite(VertexData& data, std::vector<glm::uvec3>& triangles);

/// Gives every vertex a unit normal. If the file has none, each triangle gets its own vertices and
/// is flat, as glTF requires (the file's tangents are then dropped). Single broken normals are
/// computed from the triangles around them, with a warning.
void complete_normals(VertexData& data, std::vector<glm::uvec3>& triangles,
                      const std::string& place, Warnings& warnings);

/// Gives every vertex a tangent for the material, which needs_tangents: the file's, or the
/// direction in which u of the normal map (or of another texture that needs it) grows, averaged
/// over the triangles around. If only anisotropy needs tangents, and the file has neither tangents
/// nor texture coordinates, there are none, with a warning. Needs normals.
void complete_tangents(VertexData& data, const std::vector<glm::uvec3>& triangles,
                       const Material& material, const std::string& place, Warnings& warnings);

}  // namespace asos::gltf
