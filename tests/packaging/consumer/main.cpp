// An outside project: finds contacts, and catches an error thrown inside the library.

#include <abut/abut.hpp>

#include <cstdio>
#include <string>
#include <vector>

int main() {
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
