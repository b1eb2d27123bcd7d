#pragma once

namespace asos {

/// Returns the name of the instruction set that the kernels use on this processor, such as "AVX2".
/// It changes speed alone: all sets give the same bits.
[[nodiscard]] const char* instruction_set();

}  // namespace asos
