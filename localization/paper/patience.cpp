#include "localization/paper/patience.hpp"

namespace castaway::localization {

int Patience::settle(std::optional<int> present, int preferred, Stamp now) {
  if (present == preferred) {
    since_.reset();
    return preferred;
  }
  if (!since_) since_ = now;
  if (present && seconds(now - *since_) < wait_s_) return *present;
  since_.reset();
  return preferred;
}

}  // namespace castaway::localization
