#pragma once

// The benchmarks of `bench NAME ...`, one per file. Each takes a command line that starts with its
// name, prints its measurements, and returns the exit code.

// clang-format off
namespace asos::bench {

namespace anytime { int run(int argc, char** argv); }
namespace animation { int run(int argc, char** argv); }
namespace bias { int run(int argc, char** argv); }
namespace convergence { int run(int argc, char** argv); }
namespace costs { int run(int argc, char** argv); }
namespace equal_error { int run(int argc, char** argv); }
namespace every_scene { int run(int argc, char** argv); }
namespace latency { int run(int argc, char** argv); }
namespace opening { int run(int argc, char** argv); }
namespace many_lights { int run(int argc, char** argv); }
namespace moving { int run(int argc, char** argv); }
namespace needs { int run(int argc, char** argv); }
namespace prices { int run(int argc, char** argv); }
namespace primitives { int run(int argc, char** argv); }
namespace rays_alone { int run(int argc, char** argv); }
namespace render_ratios { int run(int argc, char** argv); }
namespace slow_kinds { int run(int argc, char** argv); }

}  // namespace asos::bench
// clang-format on
