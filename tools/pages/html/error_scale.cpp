#include "tools/pages/html/error_scale.hpp"

#include <array>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr std::array<double, 5> kEnds{0.1, 0.2, 0.5, 1.0, 5.0};  // [m] Not included.

}  // namespace

std::size_t error_step(double error_m) {
  std::size_t step = 0;
  while (step < kEnds.size() && error_m >= kEnds[step]) ++step;
  return step;
}

std::string error_legend() {
  std::string html = "<div class=\"legend\"><span>Position error [m]:</span>";
  for (std::size_t step = 0; step <= kEnds.size(); ++step) {
    const std::string words = step == 0 ? fmt::format("below {:g}", kEnds[0])
                              : step == kEnds.size()
                                  ? fmt::format("from {:g}", kEnds.back())
                                  : fmt::format("{:g} to {:g}", kEnds[step - 1], kEnds[step]);
    html += fmt::format(
        "<span><svg class=\"sample\" viewBox=\"0 0 26 10\" aria-hidden=\"true\"><line "
        "class=\"e{}\" "
        "x1=\"1\" x2=\"25\" y1=\"5\" y2=\"5\"/></svg>{}</span>",
        step, words);
  }
  return html + "</div>\n";
}

}  // namespace castaway::testbed
