#include "io/write/digest.hpp"

#include "io/write/little_endian.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <memory>

namespace abut::io {
namespace {

constexpr std::size_t block_bytes = std::size_t{64} << 10;

struct FreeContext {
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};

void require(bool done) {
  if (!done) throw Error(ErrorCode::unexpected, "libcrypto could not compute a SHA-256");
}

}  // namespace

std::string digest(std::span<const ContactPair> pairs, std::span<const ImageShift> shifts) {
  const std::unique_ptr<EVP_MD_CTX, FreeContext> context(EVP_MD_CTX_new());
  require(context != nullptr);
  require(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1);

  std::string block;
  const auto flush = [&] {
    require(EVP_DigestUpdate(context.get(), block.data(), block.size()) == 1);
    block.clear();
  };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    append_little_endian(pairs[k].first, block);
    append_little_endian(pairs[k].second, block);
    if (!shifts.empty()) {
      append_little_endian(shifts[k].x, block);
      append_little_endian(shifts[k].y, block);
      append_little_endian(shifts[k].z, block);
    }
    if (block.size() >= block_bytes) flush();
  }
  flush();

  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned size = 0;
  require(EVP_DigestFinal_ex(context.get(), bytes.data(), &size) == 1);
  std::string result = "sha256:";
  for (unsigned k = 0; k < size; ++k) result += fmt::format("{:02x}", bytes[k]);
  return result;
}

}  // namespace abut::io
