// The one source file that tinygltf is compiled in. Pictures and outside files are read by the
// importer's own checked code, so stb_image and the file system stay out.
#define TINYGLTF_IMPLEMENTATION
#include "renderer/gltf/tinygltf.h"
