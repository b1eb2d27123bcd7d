#pragma once

#include "renderer/gltf/vertices.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// Keeps only triangles whose vertices are all finite, and makes the others' vertices finite.
/// Returns how many triangles went.
std::size_t drop_infinite(VertexData& data, std::vector<glm::uvec3>& triangles);

/// Gives every vertex a unit normal: where the file has none each triangle gets vertices of its
/// own and is flat, as glTF asks (its tangents are then void too); single normals that are broken
/// are made from the triangles around them, with a warning.
void complete_normals(VertexData& data, std::vector<glm::uvec3>& triangles,
                      const std::string& place, Warnings& warnings);

/// Gives every vertex a tangent for the material, which needs_tangents: the file's, or one along
/// the direction in which u grows, averaged over the triangles around: that of the normal map, or
/// of what else needs it. None where only anisotropy needs them and there are no texture
/// coordinates either, with a warning. Needs normals.
void complete_tangents(VertexData& data, const std::vector<glm::uvec3>& triangles,
                       const Material& material, const std::string& place, Warnings& warnings);

}  // namespace asos::gltf
