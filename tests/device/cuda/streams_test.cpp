// What only CUDA has: streams, and memory of several kinds. Run on a device by
// scripts/test --device.

#include "device/face/face_detection.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cuda_runtime_api.h>

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <thread>
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

/// Work that a stream has not come to yet is no error, although the runtime answers with one where
/// it is asked.
TEST(DeviceStreams, MayBeBusy) {
  const scenes::Scene scene = dense(2000);
  const device::ElementCopy copy(view_of(scene));
  const PairVector expected = pairs_of(list_by_face(view_of(scene)));
  cudaStream_t stream = nullptr;
  ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  {
    device::Detector detector;
    for (int turn = 0; turn < 3; ++turn) {
      const auto sleep = [](void*) { std::this_thread::sleep_for(std::chrono::milliseconds(50)); };
      ASSERT_EQ(cudaLaunchHostFunc(stream, sleep, nullptr), cudaSuccess);
      ASSERT_EQ(cudaStreamQuery(stream), cudaErrorNotReady);
      const device::PairList& list =
          detector.find_contact_pairs(copy.elements(), Domain::open(), {stream});
      EXPECT_EQ(pairs_of(list.to_host()), expected);
    }
  }
  EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
}

/// A graph has no place for the numbers that a detection waits for. The recording goes on.
TEST(DeviceStreams, ThatRecordAGraphAreRefused) {
  const device::ElementCopy copy(view_of(dense(100)));
  cudaStream_t stream = nullptr;
  ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  device::Detector detector;
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  expect_error(ErrorCode::wrong_usage, {"records a graph"},
               [&] { detector.count_contact_pairs(copy.elements(), Domain::open(), {stream}); });
  cudaGraph_t graph = nullptr;
  EXPECT_EQ(cudaStreamEndCapture(stream, &graph), cudaSuccess);
  EXPECT_EQ(cudaGraphDestroy(graph), cudaSuccess);
  detector.count_contact_pairs(copy.elements(), Domain::open(), {stream});
  detector.count_contact_pairs(copy.elements());
  EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
}

/// What the caller has met and gone on from is not blamed on a detection; what the caller may not
/// know of is told once.
TEST(DeviceErrors, OfCallsBefore) {
  const device::ElementCopy copy(view_of(dense(500)));
  device::Detector detector;
  const PairCount expected = detector.count_contact_pairs(copy.elements()).contact_pairs;
  void* none = nullptr;
  ASSERT_EQ(cudaMalloc(&none, std::size_t{1} << 60), cudaErrorMemoryAllocation);
  EXPECT_EQ(detector.count_contact_pairs(copy.elements()).contact_pairs, expected);
  cudaStream_t stream = nullptr;
  ASSERT_NE(cudaStreamCreateWithFlags(&stream, 12345), cudaSuccess);
  expect_error(ErrorCode::unexpected, {"a call of CUDA before this detection has failed"},
               [&] { detector.count_contact_pairs(copy.elements()); });
  EXPECT_EQ(detector.count_contact_pairs(copy.elements()).contact_pairs, expected);
  EXPECT_EQ(cudaGetLastError(), cudaSuccess);
}

/// The pool of the runtime finds no memory: the error says how much there is, and detectors work
/// on.
TEST(DeviceErrors, OfADeviceThatIsFull) {
  constexpr std::size_t many = 2'000'000;
  const device::ElementCopy copy(view_of(dense(many)));
  const device::ElementCopy few(view_of(dense(500)));
  device::Detector detector;
  const PairCount pairs_of_few = detector.count_contact_pairs(few.elements()).contact_pairs;
  std::size_t free = 0;
  std::size_t total = 0;
  ASSERT_EQ(cudaMemGetInfo(&free, &total), cudaSuccess);
  {
    Block ballast;
    // Two million elements take 128 MB and more.
    ASSERT_EQ(cudaMalloc(&ballast.first, free - (std::size_t{64} << 20)), cudaSuccess);
    for (int again = 0; again < 2; ++again) {
      expect_error(ErrorCode::limit_exceeded,
                   {"bytes are needed on the device", "of " + std::to_string(total), "free"},
                   [&] { detector.find_contact_pairs(copy.elements()); });
      EXPECT_EQ(cudaGetLastError(), cudaSuccess);
      EXPECT_EQ(detector.count_contact_pairs(few.elements()).contact_pairs, pairs_of_few);
    }
    expect_error(ErrorCode::limit_exceeded, {"bytes are needed on the device"},
                 [&] { const device::ElementCopy second(view_of(dense(3 * many))); });
  }
  EXPECT_GT(detector.find_contact_pairs(copy.elements()).size(), many);
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

}  // namespace
}  // namespace abut::testing
