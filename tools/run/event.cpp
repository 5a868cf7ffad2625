#include "tools/run/frame.hpp"

namespace castaway::testbed {

std::string localizer_of(const EventData& what) {
  return std::visit(
      [](const auto& sort) -> std::string {
        if constexpr (requires { sort.localizer; }) return sort.localizer;
        return {};
      },
      what);
}

std::string object_of(const sim::WorldNews& news) {
  return std::visit(
      [](const auto& change) -> std::string {
        if constexpr (requires { change.name; }) return change.name;
        return {};
      },
      news.what);
}

}  // namespace castaway::testbed
