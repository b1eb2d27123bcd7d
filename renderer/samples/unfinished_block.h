#pragma once

#include "renderer/film/block_result.h"
#include "renderer/samples/block_job.h"

#include <cstddef>
#include <memory>

namespace asos {

/// A block that its method has started and can continue.
class UnfinishedBlock {
 public:
  UnfinishedBlock() = default;
  virtual ~UnfinishedBlock() = default;
  UnfinishedBlock(const UnfinishedBlock&) = delete;
  UnfinishedBlock& operator=(const UnfinishedBlock&) = delete;

  /// The final pixels. Once; `job` is the one that the block was started with, but for its stop.
  [[nodiscard]] virtual BlockResult finish(const BlockJob& job) = 0;
  /// The squared error of display intensity, summed over the pixels, that a sample more is likely
  /// to take away.
  [[nodiscard]] virtual double gain() const = 0;
  /// Memory that it holds.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// A block as its method leaves it the first time.
struct StartedBlock {
  BlockResult result;                     ///< the pixels as far as they are known
  std::unique_ptr<UnfinishedBlock> rest;  ///< null: they are final
};

}  // namespace asos
