#include "io/write/digest.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace abut::io {
namespace {

// Expected values by `printf '...' | sha256sum`.

TEST(Digest, NoPairsIsTheDigestOfNothing) {
  EXPECT_EQ(digest({}), "sha256:e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Digest, PairsAsLittleEndianUint32) {
  // printf '\x00\x00\x00\x00\x01\x00\x00\x00\x04\x03\x02\x01\xfe\xff\xff\xff'
  const std::vector<ContactPair> pairs{{0, 1}, {0x01020304, 0xFFFFFFFE}};
  EXPECT_EQ(digest(pairs),
            "sha256:dc6b80b0320d3514b2081ee1d49b31ef50cc9c4dd6ab1e1f8bc23084455ae78d");
}

TEST(Digest, ManyBlocks) {
  // python3 -c 'import struct,sys; [sys.stdout.buffer.write(struct.pack("<II", k, k + 1))
  //             for k in range(100000)]'
  std::vector<ContactPair> pairs;
  for (std::uint32_t k = 0; k < 100'000; ++k) pairs.push_back({k, k + 1});
  EXPECT_EQ(digest(pairs),
            "sha256:a445db135b1ce7c2e37c122d10d99cba834a258b0902a4153ef53606a0fc9010");
}

TEST(Digest, WithImageShifts) {
  // struct.pack("<IIiii", 0, 0, 1, -2, 3) and (0, 0x01020304, -2147483647, 0, 2147483647)
  const std::vector<ContactPair> pairs{{0, 0}, {0, 0x01020304}};
  const std::vector<ImageShift> shifts{{1, -2, 3}, {-2147483647, 0, 2147483647}};
  EXPECT_EQ(digest(pairs, shifts),
            "sha256:4ff8ae22122b9ba49c7fcab7eac18fdb7ad94d0a30844a0fa7b0514e87a454bd");
}

TEST(Digest, OrderMatters) {
  const std::vector<ContactPair> one{{0, 1}, {0, 2}};
  const std::vector<ContactPair> other{{0, 2}, {0, 1}};
  EXPECT_NE(digest(one), digest(other));
}

}  // namespace
}  // namespace abut::io
