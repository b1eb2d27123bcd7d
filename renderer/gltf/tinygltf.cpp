// The only source file that compiles tinygltf. The importer's own checked code reads pictures and
// outside files, so stb_image and the file system stay out.
#define TINYGLTF_IMPLEMENTATION
#include "renderer/gltf/tinygltf.h"
