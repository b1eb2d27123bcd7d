#pragma once

#include "renderer/film/block_result.h"
#include "renderer/samples/block_job.h"

#include <cstddef>
#include <memory>

namespace asos {

/// A block that a method has started and can continue.
class UnfinishedBlock {
 public:
  UnfinishedBlock() = default;
  virtual ~UnfinishedBlock() = default;
  UnfinishedBlock(const UnfinishedBlock&) = delete;
  UnfinishedBlock& operator=(const UnfinishedBlock&) = delete;

  /// Returns the final pixels. May be called once; `job` is the original one, except for its stop
  /// token.
  [[nodiscard]] virtual BlockResult finish(const BlockJob& job) = 0;
  /// Returns the expected squared error of display intensity, summed over the pixels.
  [[nodiscard]] virtual double squared_error() const = 0;
  /// Returns the memory in use.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// A block after its method's first stage.
struct StartedBlock {
  BlockResult result;                     ///< the current estimate of the pixels
  std::unique_ptr<UnfinishedBlock> rest;  ///< null: the pixels are final
};

}  // namespace asos
