#pragma once

// tinygltf as the importer uses it: it reads the JSON; see preflight.h for what it is not given.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_INCLUDE_JSON
#include <nlohmann/json.hpp>

#include <fstream>
#include <tiny_gltf.h>
