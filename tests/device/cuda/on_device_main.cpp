// Runs the tests of a device; without one it says why there is none, and ends with exit code 6.

#include <abut/device.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <iostream>

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  try {
    const abut::device::Detector detector;
  } catch (const abut::Error& error) {
    std::cerr << "on_device_test: " << error.what() << '\n';
    return static_cast<int>(error.code());
  }
  return RUN_ALL_TESTS();
}
