#pragma once

namespace abut::cli {

enum class VersionDetail { number, build };

struct VersionOptions {
  VersionDetail detail = VersionDetail::number;
};

void run(const VersionOptions& options);

}  // namespace abut::cli
