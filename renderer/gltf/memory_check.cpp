#include "renderer/gltf/memory_check.h"

#include <fmt/format.h>

#include <unistd.h>

namespace asos::gltf {

std::uint64_t memory_of_machine() {
  return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

Checked<void> check_memory(std::uint64_t triangles, std::uint64_t objects, std::uint64_t most) {
  // Memory of a finished scene (docs/performance.md); building it takes half as much again.
  constexpr std::uint64_t bytes_a_triangle = 220, bytes_an_object = 300;
  const std::uint64_t needed = bytes_a_triangle * triangles + bytes_an_object * objects;
  if (needed <= most) return {};
  return fault(fmt::format(
      "has {} triangles, lines and points or more, in {} objects: they take {:.1f} GB "
      "of memory, and this machine has {:.1f} GB",
      triangles, objects, static_cast<double>(needed) / 1e9, static_cast<double>(most) / 1e9));
}

}  // namespace asos::gltf
