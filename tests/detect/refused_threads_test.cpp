// Threads that the system refuses: fewer work, and the bytes are the same.

#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"
#include "support/thread_faults.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <thread>
#include <vector>

namespace abut::testing {
namespace {

constexpr int asked = 5;

const scenes::Scene& scene() {
  static const scenes::Scene made = scenes::scene_named("gas").make(60000, 1);
  return made;
}

/// `call(k)` in threads of their own, whose helpers are refused from number k on.
template <class Call>
void with_refused_threads(Call&& call) {
  for (int refused = 0; refused <= asked; ++refused) {
    SCOPED_TRACE(refused);
    const ThreadFault fault(static_cast<std::uint64_t>(refused), Thread::refused);
    std::thread([&] { call(std::min(refused + 1, asked)); }).join();
  }
}

TEST(RefusedThreads, ChangeNoListAndAreNotCounted) {
  const Domain block = Domain::periodic({50.0, 50.0, 50.0});
  for (const Domain& domain : {Domain::open(), block}) {
    for (const Order order : {Order::canonical, Order::as_found}) {
      Options options{.order = order, .shifts = Shifts::stored, .threads = 1};
      const PairList expected = find_contact_pairs(view_of(scene()), domain, options);
      options.threads = asked;
      with_refused_threads([&](int threads) {
        const PairList found = find_contact_pairs(view_of(scene()), domain, options);
        EXPECT_EQ(found.statistics().threads, threads);
        EXPECT_TRUE(std::ranges::equal(found.pairs(), expected.pairs()));
        EXPECT_TRUE(std::ranges::equal(found.shifts(), expected.shifts()));
      });
    }
  }
}

TEST(RefusedThreads, ChangeNoNeighborListNorContactsWithBoxes) {
  std::vector<std::array<double, 3>> lower;
  std::vector<std::array<double, 3>> upper;
  for (std::size_t k = 0; k < scene().size(); k += 10) {
    lower.push_back({scene().x[k], scene().y[k], scene().z[k]});
    upper.push_back({scene().x[k] + 1, scene().y[k] + 1, scene().z[k] + 1});
  }
  const ElementView boxes = abut::boxes(lower, upper);
  const NeighborList expected =
      build_neighbor_list(view_of(scene()), Domain::open(), NeighborListKind::full, {.threads = 1});
  const BoxContactList expected_contacts =
      find_box_contacts(view_of(scene()), boxes, {.threads = 1});
  with_refused_threads([&](int threads) {
    const NeighborList found = build_neighbor_list(view_of(scene()), Domain::open(),
                                                   NeighborListKind::full, {.threads = asked});
    EXPECT_EQ(found.statistics().threads, threads);
    EXPECT_TRUE(std::ranges::equal(found.neighbors(), expected.neighbors()));
    const BoxContactList contacts = find_box_contacts(view_of(scene()), boxes, {.threads = asked});
    EXPECT_EQ(contacts.statistics().threads, threads);
    EXPECT_TRUE(std::ranges::equal(contacts.contacts(), expected_contacts.contacts()));
  });
}

TEST(RefusedThreads, AreAskedForAgainByADetector) {
  const PairList expected = find_contact_pairs(view_of(scene()), Domain::open(), {.threads = 1});
  std::thread([&] {
    Detector detector({.threads = asked});
    {
      const ThreadFault fault(1, Thread::refused);
      EXPECT_EQ(detector.find_contact_pairs(view_of(scene())).statistics().threads, 2);
    }
    const PairList& found = detector.find_contact_pairs(view_of(scene()));
    EXPECT_EQ(found.statistics().threads, asked);
    EXPECT_TRUE(std::ranges::equal(found.pairs(), expected.pairs()));
  }).join();
}

TEST(LateThreads, HoldUpNobody) {
  const PairList expected = find_contact_pairs(view_of(scene()), Domain::open(), {.threads = 1});
  std::thread([&] {
    Detector detector({.threads = asked});
    {
      const ThreadFault fault(0, Thread::late);
      for (int again = 0; again < 3; ++again) {
        const PairList& found = detector.find_contact_pairs(view_of(scene()));
        EXPECT_TRUE(std::ranges::equal(found.pairs(), expected.pairs()));
      }
    }
    EXPECT_TRUE(std::ranges::equal(detector.find_contact_pairs(view_of(scene())).pairs(),
                                   expected.pairs()));
  }).join();
}

/// Arrays follow the threads that there are, not those that were asked for.
TEST(RefusedThreads, TakeNoMemory) {
  const auto working_bytes = [](int threads) {
    return count_contact_pairs(view_of(scene()), Domain::open(), {.threads = threads})
        .working_bytes;
  };
  const std::uint64_t of_one = working_bytes(1);
  const ThreadFault fault(0, Thread::refused);
  std::thread([&] { EXPECT_EQ(working_bytes(100000), of_one); }).join();
}

}  // namespace
}  // namespace abut::testing
