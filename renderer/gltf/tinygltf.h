#pragma once

// tinygltf with the importer's options: it only reads the JSON. document.cpp and tidy.h withhold
// the other parts from it.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_INCLUDE_JSON
#include <nlohmann/json.hpp>

#include <fstream>
#include <tiny_gltf.h>
