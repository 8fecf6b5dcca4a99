#include "engine/layers/layer_cursors.hpp"

#include <algorithm>

namespace abut::engine {

LayerCursors::LayerCursors(base::MemoryMeter& memory)
    : begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)), cursors_(begin_) {}

void LayerCursors::start(std::size_t layers, std::size_t workers) {
  base::make_room(cursors_, workers * layers);
  base::make_room(begin_, layers + 1);
  std::fill_n(cursors_.data(), workers * layers, std::uint64_t{0});
  layers_ = layers;
  workers_ = workers;
}

void LayerCursors::lay_out() noexcept {
  largest_ = 0;
  std::uint64_t filled = 0;
  for (std::size_t layer = 0; layer < layers_; ++layer) {
    begin_[layer] = filled;
    for (std::size_t w = 0; w < workers_; ++w) {
      std::uint64_t& cursor = cursors_[w * layers_ + layer];
      const std::uint64_t count = cursor;
      cursor = filled;
      filled += count;
    }
    largest_ = std::max(largest_, static_cast<std::size_t>(filled - begin_[layer]));
  }
  begin_[layers_] = filled;
}

}  // namespace abut::engine
