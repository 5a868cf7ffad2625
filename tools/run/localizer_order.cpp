#include "tools/run/localizer_order.hpp"

#include <array>

namespace castaway::testbed {

const char* to_string(LocalizerOrder::What what) {
  constexpr std::array<const char*, 4> kNames = {"initialize", "relocalize", "off", "on"};
  return kNames.at(static_cast<std::size_t>(what));
}

}  // namespace castaway::testbed
