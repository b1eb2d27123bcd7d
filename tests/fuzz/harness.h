#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// The functions that libFuzzer calls, or else the main() of replay.cpp.

extern "C" {
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most_bytes);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most_bytes,
                                    unsigned int seed);
}

namespace asos::fuzz {

/// Ends the program with this message, so that the input is kept, if a guarantee is violated.
void require(bool holds, const std::string& promise);

/// Writes the bytes to a file of this name and returns its path. The file exists until the next
/// call with this name; its folder belongs to this process alone.
[[nodiscard]] std::string input_file(const std::string& name, const std::uint8_t* data,
                                     std::size_t size);

/// Passes a mutator's result to libFuzzer and returns its length. If it does not fit, libFuzzer
/// mutates the input itself.
[[nodiscard]] std::size_t mutated(std::string_view made, std::uint8_t* data, std::size_t size,
                                  std::size_t most_bytes);

}  // namespace asos::fuzz
