#include "tools/pages/run/pictures_section.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/html_page.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMaxPictures = 60;  // Keeps the page at about 5 MB.

bool is_by_time(const ReportPicture& picture) {
  return picture.name.find("-time-") != std::string::npos;
}

/// "t0032.100-kidnap-1-map.png": "32.100 s, kidnap 1, map".
std::string caption(const std::string& name) {
  const std::size_t first = name.find('-');
  const std::size_t last = name.rfind('-');
  const std::size_t digit = name.find_first_of("123456789.");
  if (name[0] != 't' || last <= first || digit >= first) return escape_html(name);
  const std::size_t begin = name[digit] == '.' ? digit - 1 : digit;
  std::string what = name.substr(first + 1, last - first - 1);
  std::replace(what.begin(), what.end(), '-', ' ');
  const std::string view = name.substr(last + 1, name.rfind('.') - last - 1);
  return escape_html(fmt::format("{} s, {}, {}", name.substr(begin, first - begin), what, view));
}

}  // namespace

std::string pictures_section(const RunFolder& run) {
  if (run.pictures.empty()) {
    const std::string reason = run.pictures_missing.value_or("none was asked for");
    return html_section("Pictures",
                        fmt::format("<p>There are no pictures: {}</p>\n", escape_html(reason)));
  }
  std::string html =
      "<p class=\"soft\">On the map: the truth in black, each localizer in its colour, its "
      "particles in shades of it, one a population. In the room: lidar hits in red.</p>\n"
      "<div class=\"pictures\">";
  const bool drop_by_time = run.pictures.size() > kMaxPictures;
  std::size_t shown = 0;
  for (const ReportPicture& picture : run.pictures) {
    if (shown == kMaxPictures || (drop_by_time && is_by_time(picture))) continue;
    ++shown;
    html +=
        fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                    caption(picture.name), png_data_uri(picture.png));
  }
  html += "</div>\n";
  if (shown < run.pictures.size()) {
    html += fmt::format("<p class=\"soft\">{} more in the folder snapshots.</p>\n",
                        run.pictures.size() - shown);
  }
  return html_section("Pictures", html);
}

}  // namespace castaway::testbed
