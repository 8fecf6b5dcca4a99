#include "base/thread_team.hpp"

#include "support/thread_faults.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <latch>
#include <set>
#include <thread>
#include <vector>

#include <pthread.h>
#include <signal.h>

namespace abut::testing {
namespace {

using testing::Thread;
using testing::ThreadFault;

/// Has the team call body(share) for each share.
template <class Body>
void run(base::ThreadTeam& team, std::size_t count, Body&& body) {
  team.run({[](void* context, std::size_t share) { (*static_cast<Body*>(context))(share); }, &body,
            count});
}

void expect_each_share_once(base::ThreadTeam& team, std::size_t count) {
  std::vector<std::atomic<int>> calls(count);
  run(team, count, [&](std::size_t share) { ++calls.at(share); });
  for (const auto& number : calls) EXPECT_EQ(number, 1);
}

TEST(ThreadTeam, DoesEachShareOnceWhateverItsSize) {
  for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
    base::ThreadTeam team;
    EXPECT_EQ(team.grow(threads), threads);
    for (int again = 0; again < 200; ++again) {
      for (const std::size_t count : {1U, 2U, 3U, 7U, 8U, 9U, 40U}) {
        expect_each_share_once(team, count);
      }
    }
  }
}

TEST(ThreadTeam, WorksInAsManyThreadsAtTheSameTime) {
  base::ThreadTeam team;
  ASSERT_EQ(team.grow(4), 4U);
  for (int again = 0; again < 20; ++again) {
    std::latch all(4);
    std::array<std::thread::id, 4> ids{};
    run(team, 4, [&](std::size_t share) {
      ids.at(share) = std::this_thread::get_id();
      all.arrive_and_wait();
    });
    EXPECT_EQ(ids[0], std::this_thread::get_id());
    EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), 4U);
  }
}

TEST(ThreadTeam, HasFewerThreadsWhereSomeAreRefused) {
  for (std::uint64_t refused = 0; refused < 6; ++refused) {
    base::ThreadTeam team;
    {
      const ThreadFault fault(refused, Thread::refused);
      EXPECT_EQ(team.grow(6), refused + 1 < 6 ? refused + 1 : 6);
      EXPECT_EQ(fault.requests(), refused < 5 ? refused + 1 : 5);
      expect_each_share_once(team, 6);
    }
    EXPECT_EQ(team.grow(6), 6U) << "what was refused is asked for again";
    expect_each_share_once(team, 6);
  }
}

TEST(ThreadTeam, DoesNotWaitForHelpersThatAreLate) {
  base::ThreadTeam team;
  const ThreadFault fault(1, Thread::late);
  ASSERT_EQ(team.grow(4), 4U);
  for (int again = 0; again < 100; ++again) expect_each_share_once(team, 4);
}

TEST(ThreadTeam, EndsItsThreads) {
  const std::uint64_t before = testing::threads_of_process();
  for (int again = 0; again < 5; ++again) {
    base::ThreadTeam team;
    ASSERT_EQ(team.grow(5), 5U);
    EXPECT_TRUE(testing::process_comes_to(before + 4));
  }
  EXPECT_TRUE(testing::process_comes_to(before));
}

TEST(ThreadTeam, LeavesSignalsToTheCaller) {
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, nullptr, &before);
  base::ThreadTeam team;
  ASSERT_EQ(team.grow(2), 2U);
  std::array<sigset_t, 2> masks{};
  std::latch both(2);
  run(team, 2, [&](std::size_t share) {
    pthread_sigmask(SIG_BLOCK, nullptr, &masks.at(share));
    both.arrive_and_wait();
  });
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGUSR1, SIGCHLD}) {
    EXPECT_EQ(sigismember(&masks[0], signal), sigismember(&before, signal));
    EXPECT_EQ(sigismember(&masks[1], signal), 1);
  }
  EXPECT_EQ(sigismember(&masks[1], SIGSEGV), 0) << "a fault of its own is handled as any other";
}

TEST(ThreadTeam, HelpersHaveRoomOnTheirStacks) {
  base::ThreadTeam team;
  ASSERT_EQ(team.grow(2), 2U);
  std::size_t size = 0;
  std::latch both(2);
  run(team, 2, [&](std::size_t share) {
    both.arrive_and_wait();
    if (share == 0) return;
    pthread_attr_t attributes;
    pthread_getattr_np(pthread_self(), &attributes);
    pthread_attr_getstacksize(&attributes, &size);
    pthread_attr_destroy(&attributes);
  });
  EXPECT_GE(size, std::size_t{1} << 20);
}

TEST(OwnTeam, IsTheThreadsOwnAndEndsWithIt) {
  const std::uint64_t before = testing::threads_of_process();
  base::ThreadTeam* first = nullptr;
  std::latch both(2);
  const auto use = [&](base::ThreadTeam*& own) {
    EXPECT_EQ(base::own_team_so_far(), nullptr);
    own = base::own_team();
    ASSERT_NE(own, nullptr);
    EXPECT_EQ(base::own_team(), own);
    EXPECT_EQ(base::own_team_so_far(), own);
    EXPECT_EQ(own->grow(3), 3U);
    expect_each_share_once(*own, 3);
    both.arrive_and_wait();
  };
  base::ThreadTeam* second = nullptr;
  std::thread one(use, std::ref(first));
  std::thread other(use, std::ref(second));
  one.join();
  other.join();
  EXPECT_NE(first, second);
  EXPECT_TRUE(testing::process_comes_to(before));
}

}  // namespace
}  // namespace abut::testing
