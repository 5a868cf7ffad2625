#include "sim/people/people_config.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

template <typename Value>
void require(bool condition, const char* field, Value value, const char* remedy) {
  if (condition) return;
  throw std::invalid_argument(fmt::format("people: {} is {}: {}", field, value, remedy));
}

}  // namespace

void validate(const PeopleConfig& c) {
  require(c.walking >= 0, "count", c.walking, "give 0 or more");
  require(c.standing >= 0, "standing", c.standing, "give 0 or more");
  for (const int size : c.talking) require(size >= 2 && size <= 6, "talking", size, "give 2 to 6");
  require(c.count() <= kMaxPeople, "count of all", c.count(), "give at most 200");
  require(c.in_groups >= 0.0 && c.in_groups <= 1.0, "groups", c.in_groups, "give 0 to 1");
  require(c.blocked_share >= 0.0 && c.blocked_share <= 0.6, "crowd.blocked", c.blocked_share,
          "give 0 to 0.6");
}

}  // namespace castaway::sim
