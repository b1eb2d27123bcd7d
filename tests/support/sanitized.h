#pragma once

namespace asos::test {

/// Whether the sanitizers watch, under which code is some ten times slower: tests that try many
/// cases of one kind try fewer then.
#ifdef ASOS_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace asos::test
