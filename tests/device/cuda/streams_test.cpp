// What only CUDA has: streams, and memory of several kinds. Run on a device by
// scripts/test --device.

#include "device/face_detection.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cuda_runtime_api.h>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::testing {
namespace {

/// Memory of a kind, with the function that releases it.
struct Block {
  void* first = nullptr;
  cudaError_t (*free)(void*) = cudaFree;

  ~Block() { static_cast<void>(free(first)); }
  [[nodiscard]] double* numbers() const { return static_cast<double*>(first); }
};

scenes::Scene dense(std::size_t count) {
  return scenes::scene_named("dense").make(count, 1);
}

TEST(DeviceStreams, OneDetectorInSeveral) {
  const scenes::Scene scene = dense(elements_of_a_scene());
  const device::ElementCopy copy(view_of(scene));
  const PairVector expected = pairs_of(list_by_face(view_of(scene)));
  device::Detector detector;
  std::vector<cudaStream_t> streams(3);
  for (cudaStream_t& stream : streams) {
    ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  }
  for (int turn = 0; turn < 9; ++turn) {
    const device::Stream stream{streams[static_cast<std::size_t>(turn) % streams.size()]};
    const device::PairList& list =
        detector.find_contact_pairs(copy.elements(), Domain::open(), stream);
    // Every other list is left as it is, while its stream still works on it.
    if (turn % 2 == 0) {
      EXPECT_EQ(pairs_of(list.to_host()), expected) << turn;
    }
  }
  detector.count_contact_pairs(copy.elements());
  for (cudaStream_t stream : streams) EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
}

/// What is put into the stream behind a call sees its list.
TEST(DeviceStreams, AListIsValidInTheirOrder) {
  const scenes::Scene scene = dense(elements_of_a_scene());
  const device::ElementCopy copy(view_of(scene));
  const PairVector expected = pairs_of(list_by_face(view_of(scene)));
  cudaStream_t stream = nullptr;
  ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  {
    device::Detector detector;
    const device::PairList& list =
        detector.find_contact_pairs(copy.elements(), Domain::open(), {stream});
    PairVector found(list.size());
    ASSERT_EQ(cudaMemcpyAsync(found.data(), list.data(), found.size() * sizeof(ContactPair),
                              cudaMemcpyDeviceToHost, stream),
              cudaSuccess);
    ASSERT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
    EXPECT_EQ(found, expected);
  }
  EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
}

TEST(DeviceColumns, OfOtherKindsOfMemory) {
  constexpr std::size_t count = 10;
  Block managed;
  Block pinned{nullptr, cudaFreeHost};
  ASSERT_EQ(cudaMallocManaged(&managed.first, count * sizeof(double), cudaMemAttachGlobal),
            cudaSuccess);
  ASSERT_EQ(cudaMallocHost(&pinned.first, count * sizeof(double)), cudaSuccess);
  for (std::size_t k = 0; k < count; ++k) managed.numbers()[k] = 1.5 * static_cast<double>(k);
  const std::span<const double> x(managed.numbers(), count);
  device::Detector detector;
  EXPECT_EQ(detector.count_contact_pairs(discs(x, x, 1.1)).contact_pairs, count - 1);
  ASSERT_EQ(cudaDeviceSynchronize(), cudaSuccess);
  const std::span<const double> on_host(pinned.numbers(), count);
  expect_error(ErrorCode::wrong_usage, {"column y", "memory of the host"},
               [&] { detector.count_contact_pairs(discs(x, on_host, 1.1)); });
}

TEST(DeviceColumns, WithStridesAndBadAddresses) {
  const scenes::Scene scene = dense(100);
  const device::ElementCopy copy(view_of(scene));
  const double* const first = reinterpret_cast<const double*>(copy.elements().center(0).first);
  device::Detector detector;
  const auto count_of = [&](Column<double> column) {
    return detector.count_contact_pairs(discs(column, column, 0.0));
  };
  // Backwards from the last, and one number for all.
  EXPECT_EQ(count_of({first + 99, 100, -std::ptrdiff_t{sizeof(double)}}).elements, 100U);
  EXPECT_EQ(count_of({first, 100, 0}).contact_pairs, 100U * 99U / 2U);
  expect_error(ErrorCode::wrong_usage, {"column x", "null"}, [&] {
    count_of({nullptr, 100, sizeof(double)});
  });
  expect_error(ErrorCode::wrong_usage, {"column x", "aligned"}, [&] { count_of({first, 10, 12}); });
}

}  // namespace
}  // namespace abut::testing
