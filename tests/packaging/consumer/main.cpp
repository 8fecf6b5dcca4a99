// An outside project: finds contacts, and catches an error thrown inside the library.

#include <abut/abut.hpp>
#if defined(WITH_DEVICE)
#include <abut/device.hpp>
#endif

#include <cstdio>
#include <string>
#include <vector>

namespace {

/// Whether a device that no machine has is refused as one that is not there.
bool devices_answer() {
#if defined(WITH_DEVICE)
  try {
    const abut::device::Detector detector({}, abut::device::on(1'000'000));
    return false;
  } catch (const abut::Error& error) {
    return error.code() == abut::ErrorCode::unavailable;
  }
#else
  return true;
#endif
}

}  // namespace

int main() {
  if (!devices_answer()) return 1;
  const std::vector<double> x{0.0, 1.0, 3.0};
  const std::vector<double> y{0.0, 0.0, 0.0};
  const abut::PairList pairs = abut::find_contact_pairs(abut::discs(x, y, 0.5));
  try {
    static_cast<void>(abut::find_contact_pairs(abut::discs(x, y, -0.5)));
    return 1;
  } catch (const abut::Error& error) {
    std::printf("abut %s, %d contact pair, refused: %s\n", std::string(abut::version()).c_str(),
                static_cast<int>(pairs.size()), error.what());
    const bool right = pairs.size() == 1 && error.code() == abut::ErrorCode::invalid_input;
    return right ? 0 : 1;
  }
}
