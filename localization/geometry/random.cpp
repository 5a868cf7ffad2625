#include "localization/geometry/random.hpp"

#include <random>
#include <vector>

namespace castaway::localization {

Rng substream(std::uint64_t seed, std::string_view name) {
  std::vector<std::uint32_t> words = {static_cast<std::uint32_t>(seed),
                                      static_cast<std::uint32_t>(seed >> 32U)};
  for (const char c : name) words.push_back(static_cast<unsigned char>(c));
  std::seed_seq sequence(words.begin(), words.end());
  return Rng(sequence);
}

}  // namespace castaway::localization
