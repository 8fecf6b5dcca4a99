#include "base/lack_of_memory.hpp"
#include "base/shortest_text.hpp"

#include <abut/error.hpp>
#include <abut/skin.hpp>

#include <cmath>

namespace abut {

Skin Skin::fixed(double length) {
  return base::reporting_lack_of_memory([&]() -> Skin {
    if (!(length >= 0.0) || std::isinf(length)) {
      throw Error(ErrorCode::invalid_input,
                  "skin = " + base::shortest_text(length) + "; it must be finite and not negative");
    }
    return {Kind::fixed, length};
  });
}

}  // namespace abut
