#include "tests/support/sanitized.h"
#include "tests/ui/ui_rig.h"
#include "ui/previewer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <malloc.h>
#include <memory>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#ifdef ASOS_SANITIZED
// GCC installs no header for this function.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace asos {
using namespace ui;
namespace {

/// A wavy square of 2 x side x side triangles.
Scene waves(int side, std::string source) {
  Scene scene{.source = std::move(source)};
  Mesh mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      mesh.positions.emplace_back(x, static_cast<float>((x * 7 + y * 3) % 5), y);
      mesh.normals.emplace_back(0, 1, 0);
    }
  }
  const auto at = [side](int x, int y) { return static_cast<unsigned>(y * (side + 1) + x); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      mesh.triangles.emplace_back(at(x, y), at(x, y + 1), at(x + 1, y));
      mesh.triangles.emplace_back(at(x + 1, y), at(x, y + 1), at(x + 1, y + 1));
    }
  }
  scene.meshes.push_back(std::move(mesh));
  Instance instance{.mesh = 0};
  scene.instances.push_back(instance);
  return scene;
}

struct Memory {
  double heap_mb = 0.0;      ///< allocated and not freed
  double resident_mb = 0.0;  ///< of the process, after free memory was returned
};

double resident_mb() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

Memory memory() {
  Memory now;
#ifdef ASOS_SANITIZED
  now.heap_mb = static_cast<double>(__sanitizer_get_current_allocated_bytes()) / 1e6;
#else
  malloc_trim(0);
  const struct mallinfo2 info = mallinfo2();
  now.heap_mb = static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
#endif
  now.resident_mb = resident_mb();
  return now;
}

// Embree keeps a few hundred bytes per thread that ever built something with it, and each load
// starts such a thread: negligible for scenes of a few megabytes.
TEST(PreviewerMemory, IsBackAfterTwoHundredScenes) {
  RenderSettings settings{.asos = {.max_level = 1}, .threads = 1};
  Previewer previewer({[](const std::string& source) -> Result<Scene> {
                         return waves(source == "large" ? 100 : 8, source);
                       },
                       {}},
                      settings);
  previewer.viewpoint().set_picture_size(64, 48, 0.0);
  const auto open = [&](const std::string& source) {
    previewer.scene().open(source);
    const auto start = std::chrono::steady_clock::now();
    while (previewer.scene().loading() || !previewer.scene() ||
           previewer.scene()->geometry->source != source) {
      previewer.update(0.0);
      if (std::chrono::steady_clock::now() - start > std::chrono::seconds(60)) return false;
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return true;
  };
  // Memory during a render varies.
  const auto rest = [&] {
    const auto start = std::chrono::steady_clock::now();
    while (!previewer.render().progress().finished &&
           std::chrono::steady_clock::now() - start < std::chrono::seconds(60)) {
      previewer.update(0.0);
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return previewer.render().progress().finished;
  };
  const auto load = [&](int scenes) {
    for (int i = 0; i < scenes; ++i) ASSERT_TRUE(open(i % 2 == 0 ? "small" : "large"));
    ASSERT_TRUE(rest());
  };
  // The first scenes fill buffers that libraries never free.
  load(30);
  Memory before = memory();
  // Resident memory varies by some per cent, so that of one more load counts, too.
  load(30);
  const Memory again = memory();
  before = {std::max(before.heap_mb, again.heap_mb),
            std::max(before.resident_mb, again.resident_mb)};
  // Fragmentation, and memory of a search for edges that is just ending, vary. Leaked memory stays,
  // so the minimum counts.
  Memory after{1e9, 1e9};
  const int loads = test::sanitized ? 8 : 40;
  for (int part = 0; part < 5; ++part) {
    load(loads);
    const Memory now = memory();
    if (part < 2) continue;
    after.heap_mb = std::min(after.heap_mb, now.heap_mb);
    after.resident_mb = std::min(after.resident_mb, now.resident_mb);
  }
  std::printf("heap %.2f MB before, %.2f after; resident %.1f MB before, %.1f after\n",
              before.heap_mb, after.heap_mb, before.resident_mb, after.resident_mb);
  // 0.9 MB: 5 % of the heap with all pictures of environments, and 4.5 kB for each scene. A leaked
  // scene has more: the large one 1 MB.
  EXPECT_LE(after.heap_mb, before.heap_mb + 0.9);
  // The sanitizers keep freed memory.
  if (!test::sanitized) {
    EXPECT_LE(after.resident_mb, 1.05 * before.resident_mb);
  }
}

// Like a user who pages through models, in the window with all that it stores about them.
TEST(WindowMemory, HoldsTheSceneThatIsOpenAndNothingElse) {
  test::UiRig rig(
      [](const std::string& source) -> Result<Scene> {
        return waves(source == "large" ? 250 : 60, source);
      },
      {300, 200});
  rig.set_pixel_size(3);
  rig.settings().asos.max_level = 0;
  std::vector<std::weak_ptr<const RenderScene>> seen;
  const auto open = [&](const std::string& source) {
    ASSERT_TRUE(rig.opens(source));
    seen.push_back(rig.scene().shared());
  };
  for (int round = 0; round < 3; ++round) {
    for (const char* source : {"large", "small", "large", "small"})
      ASSERT_NO_FATAL_FAILURE(open(source));
  }
  ASSERT_TRUE(rig.frames_until([&] {
    return rig.scene()->geometry->boundaries.known() && rig.render().progress().finished;
  }));
  ASSERT_TRUE(rig.frames_until([&] {
    return std::count_if(seen.begin(), seen.end(), [](const auto& s) { return !s.expired(); }) == 1;
  })) << "previous scenes are still in memory";
  EXPECT_EQ(seen.back().lock(), rig.scene().shared());
  if (test::sanitized) return;  // the sanitizers keep freed memory
  // Freed memory went back to the system by itself, so another request returns little.
  ASSERT_TRUE(rig.frames_until([&] { return !rig.previewer().gives_memory_back(); }));
  const double before = resident_mb();
  const Memory trimmed = memory();
  std::printf("resident %.1f MB, %.1f trimmed again; heap %.1f MB\n", before, trimmed.resident_mb,
              trimmed.heap_mb);
  EXPECT_LE(before - trimmed.resident_mb, 4.0);
}

}  // namespace
}  // namespace asos
