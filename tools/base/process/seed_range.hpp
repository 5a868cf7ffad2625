/// Seeds of repeated runs.
#pragma once

#include <cstdint>
#include <string>

namespace castaway::testbed {

/// Consecutive seeds.
struct SeedRange {
  std::uint64_t first = 1;
  int count = 1;
};

/// Parses "20" (so many seeds from `base` on) or "5..24" (both included). Throws
/// std::invalid_argument, also for more than 100000 seeds.
SeedRange parse_seeds(const std::string& text, std::uint64_t base);

}  // namespace castaway::testbed
