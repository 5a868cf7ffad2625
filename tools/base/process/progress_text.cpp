#include "tools/base/process/progress_text.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace castaway::testbed {

std::string minutes_and_seconds(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
}

std::string progress_text(int done, int all, const std::string& what, double elapsed_s) {
  const double rate = done / elapsed_s;
  std::string text = fmt::format("{} / {} {}", done, all, what);
  if (done == 0) return text;
  return text +
         fmt::format(", {:.2g} a second, {} left", rate, minutes_and_seconds((all - done) / rate));
}

}  // namespace castaway::testbed
