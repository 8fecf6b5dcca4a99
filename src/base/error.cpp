#include <abut/error.hpp>

namespace abut {

Error::Error(ErrorCode code, const std::string& sentence)
    : std::runtime_error(sentence), code_(code) {}

Error::~Error() = default;

}  // namespace abut
