#pragma once

namespace asos::test {

/// Whether the sanitizers are on, which slow code down about ten times. Tests with many cases of
/// one kind then try fewer.
#ifdef ASOS_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace asos::test
