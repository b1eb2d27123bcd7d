#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// What libFuzzer calls, and in its absence the main() of replay.cpp.

extern "C" {
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most_bytes);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most_bytes,
                                    unsigned int seed);
}

namespace asos::fuzz {

/// Ends the program, and so keeps the input, where a promise does not hold; says which.
void require(bool holds, const std::string& promise);

/// The path of a file of this name that holds the bytes until the next call with this name. Its
/// folder holds nothing else and is this process's own.
[[nodiscard]] std::string input_file(const std::string& name, const std::uint8_t* data,
                                     std::size_t size);

/// Hands what a mutator made to libFuzzer: its length, or that of what libFuzzer itself makes of
/// the input where it does not fit.
[[nodiscard]] std::size_t mutated(std::string_view made, std::uint8_t* data, std::size_t size,
                                  std::size_t most_bytes);

}  // namespace asos::fuzz
