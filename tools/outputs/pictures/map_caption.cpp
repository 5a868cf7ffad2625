#include "tools/outputs/pictures/map_caption.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/outputs/pictures/bitmap_text.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint32_t kGround = 0xFFFFFF;
constexpr std::uint32_t kInk = 0x1D2328;
constexpr double kMostBar = 0.2;  // Of the image's width.
constexpr int kMark = 9;          // [dots] Side of an entry's mark.
constexpr int kGap = 4;           // [dots] Between a mark and its name.
constexpr int kApart = 12;        // [dots] Between entries.
constexpr int kLine = 13;         // [dots]
constexpr int kRim = 4;           // [dots]

int scale_of(int height) { return std::max(1, (height + 120) / 320); }

/// The scale bar at the right of the first line [px].
struct ScaleBar {
  std::string label;
  int length = 0;
  int width = 0;  ///< Including its label.
};

ScaleBar scale_bar(double pixels_per_m, int width, int scale) {
  if (!(pixels_per_m > 0.0) || !std::isfinite(pixels_per_m)) return {};
  const double metres = round_length(kMostBar * width / pixels_per_m);
  ScaleBar bar{fmt::format("{:g} m", metres), 0, 0};
  bar.length = static_cast<int>(std::lround(metres * pixels_per_m));
  bar.width = bar.length + kGap * scale + text_width(bar.label, scale);
  return bar;
}

/// Position of an entry [px].
struct Placed {
  PixelPlace at;
  std::size_t entry = 0;
};

struct Layout {
  std::vector<Placed> entries;
  std::size_t left_out = 0;
  int lines = 1;
};

int entry_width(const std::string& name, int scale) {
  return (kMark + kGap) * scale + text_width(name, scale);
}

/// Arranges entries from left to right in lines, leaving room for the scale bar in the first line.
Layout lay_out(const MapCaption& caption, int width, int height) {
  const int scale = scale_of(height);
  const int most = std::max(1, (height / 3 / scale - kRim) / kLine);
  const int clock = caption.clock.empty() ? 0 : text_width(caption.clock, scale) + kApart * scale;
  const int bar = scale_bar(caption.pixels_per_m, width, scale).width;
  const int left = kRim * scale;
  Layout layout;
  int x = left + clock;
  for (std::size_t i = 0; i < caption.entries.size(); ++i) {
    const int needs = entry_width(caption.entries[i].name, scale);
    const auto room = [&] { return width - left - (layout.lines == 1 ? bar + kApart * scale : 0); };
    const bool fresh = layout.lines > 1 && x == left;
    if (x + needs > room() && !fresh) {
      if (layout.lines == most) {
        layout.left_out = caption.entries.size() - i;
        break;
      }
      ++layout.lines;
      x = left;
    }
    layout.entries.push_back({{x, layout.lines - 1}, i});
    x += needs + kApart * scale;
  }
  return layout;
}

void draw_mark(sim::Image& image, PixelPlace at, int side, const LegendEntry& entry) {
  const double radius = 0.5 * side;
  const double inner = entry.ring ? 0.55 * radius : 0.0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double away = std::hypot(x + 0.5 - radius, y + 0.5 - radius);
      if (away <= radius && away >= inner) set_pixel(image, {at.x + x, at.y + y}, entry.rgb);
    }
  }
}

void draw_entry(const LegendEntry& entry, PixelPlace at, int scale, sim::Image& image) {
  draw_mark(image, at, kMark * scale, entry);
  draw_text(image, {at.x + (kMark + kGap) * scale, at.y + scale}, entry.name, scale, kInk);
}

/// Draws the number of omitted entries at the right of a line.
void draw_more(std::size_t count, int top, int scale, sim::Image& image) {
  const std::string more = fmt::format("+ {} more", count);
  const int width = text_width(more, scale) + 2 * kRim * scale;
  fill_box(image, {image.width - width, top}, {width, kLine * scale}, kGround);
  draw_text(image, {image.width - width + kRim * scale, top + scale}, more, scale, kInk);
}

void draw_bar(const ScaleBar& bar, int top, int scale, sim::Image& image) {
  const int left = image.width - kRim * scale - bar.width;
  const int middle = top + kMark * scale / 2;
  fill_box(image, {left, middle}, {bar.length, scale}, kInk);
  for (const int x : {left, left + bar.length - scale}) {
    fill_box(image, {x, top + scale}, {scale, (kMark - 2) * scale}, kInk);
  }
  draw_text(image, {left + bar.length + kGap * scale, top + scale}, bar.label, scale, kInk);
}

}  // namespace

double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most) + 1e-9));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= most * (1.0 + 1e-9)) return digit * power;
  }
  return power;
}

int caption_height(const MapCaption& caption, int width, int height) {
  return std::min(height / 3,
                  (lay_out(caption, width, height).lines * kLine + kRim) * scale_of(height));
}

void draw_caption(const MapCaption& caption, sim::Image& image) {
  const int scale = scale_of(image.height);
  const Layout layout = lay_out(caption, image.width, image.height);
  const int top = image.height - caption_height(caption, image.width, image.height);
  fill_box(image, {0, top}, {image.width, image.height - top}, kGround);
  const auto line_top = [&](int line) { return top + (kRim + kLine * line) * scale; };
  draw_text(image, {kRim * scale, line_top(0) + scale}, caption.clock, scale, kInk);
  for (const auto& [at, entry] : layout.entries) {
    draw_entry(caption.entries[entry], {at.x, line_top(at.y)}, scale, image);
  }
  if (layout.left_out > 0) {
    draw_more(layout.left_out, line_top(layout.lines - 1), scale, image);
  }
  const ScaleBar bar = scale_bar(caption.pixels_per_m, image.width, scale);
  if (bar.length > 0) draw_bar(bar, line_top(0), scale, image);
}

}  // namespace castaway::testbed
