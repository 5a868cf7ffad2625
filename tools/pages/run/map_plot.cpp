#include "tools/pages/run/map_plot.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "tools/base/formats/html.hpp"
#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/pages/html/error_scale.hpp"
#include "tools/pages/html/line_chart.hpp"
#include "tools/pages/run/map_svg.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;

constexpr double kJump = 1.0;       // [m]
constexpr double kMapMargin = 1.0;  // [m] Around the paths if there is no map.

/// Poses of one kind in the rows of a curve.
struct Track {
  std::optional<SE2> ReportRow::*pose;
  std::optional<double> ReportRow::*z;
};

constexpr Track kTrue{&ReportRow::T_map_base_true, &ReportRow::z_true};
constexpr Track kEstimated{&ReportRow::T_map_base_estimate, &ReportRow::z_estimate};

/// True for the rows to be drawn on a floor.
using OnFloor = std::function<bool(std::optional<double> z)>;

/// An empty grid around all poses.
RosMap bounding_grid(const RunFolder& run) {
  Eigen::AlignedBox2d bounds;
  for (const ReportCurve& curve : run.curves) {
    for (const ReportRow& row : curve.rows) {
      for (const auto& pose : {row.T_map_base_true, row.T_map_base_estimate}) {
        if (pose) bounds.extend(pose->translation());
      }
    }
  }
  if (bounds.isEmpty()) bounds.extend(Eigen::Vector2d(0.0, 0.0));
  RosMap grid;
  grid.origin_x = bounds.min().x() - kMapMargin;
  grid.origin_y = bounds.min().y() - kMapMargin;
  grid.width = static_cast<int>(std::ceil((bounds.sizes().x() + 2 * kMapMargin) / grid.resolution));
  grid.height =
      static_cast<int>(std::ceil((bounds.sizes().y() + 2 * kMapMargin) / grid.resolution));
  return grid;
}

bool has_truth(const ReportCurve& curve) {
  return std::any_of(curve.rows.begin(), curve.rows.end(),
                     [](const ReportRow& row) { return row.T_map_base_true.has_value(); });
}

std::string path_data(const ReportCurve& curve, const Track& track, const RosMap& map,
                      const OnFloor& on_floor) {
  std::string path;
  std::optional<SE2> last;
  for (const ReportRow& row : curve.rows) {
    const std::optional<SE2>& pose = row.*track.pose;
    if (!pose) continue;
    if (!on_floor(row.*track.z)) {
      last.reset();
      continue;
    }
    const bool joined = last && localization::distance(*last, *pose) <= kJump;
    const Eigen::Vector2d p = map_pixel(map, pose->translation());
    path += fmt::format("{}{:.1f} {:.1f}", joined ? 'L' : 'M', p.x(), p.y());
    last = pose;
  }
  return path;
}

/// One map of a plot.
struct PlotMap {
  const RosMap& grid;
  bool drawn;  ///< False: only the paths are.
  OnFloor on_floor;
  std::string where{};  ///< "level 1: 3.00 m"; empty with one floor.
};

std::string path_element(const std::string& name, const std::string& style, const std::string& data,
                         double stroke) {
  return fmt::format("<path class=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\"><title>{}</title></path>",
                     style, stroke, data, escape_html(name));
}

/// The true path in pieces of one colour: those of the position error, grey without an answer.
std::string error_paths(const ReportCurve& curve, const PlotMap& map, double stroke) {
  std::string svg;
  std::string data;
  std::string style;
  std::optional<SE2> last;
  const auto flush = [&] {
    if (!data.empty()) {
      svg += fmt::format("<path class=\"path {}\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", style,
                         3.0 * stroke, data);
    }
    data.clear();
  };
  for (const ReportRow& row : curve.rows) {
    const std::optional<SE2>& pose = row.T_map_base_true;
    if (!pose) continue;
    const bool here = map.on_floor(row.z_true);
    const bool joined = here && last && localization::distance(*last, *pose) <= kJump;
    const auto& error = row.position_error_m;
    const std::string now = error ? fmt::format("e{}", error_step(*error)) : "unscored";
    if (!joined || now != style) flush();
    if (joined) {
      if (data.empty()) {
        const Eigen::Vector2d from = map_pixel(map.grid, last->translation());
        data = fmt::format("M{:.1f} {:.1f}", from.x(), from.y());
      }
      const Eigen::Vector2d p = map_pixel(map.grid, pose->translation());
      data += fmt::format("L{:.1f} {:.1f}", p.x(), p.y());
    }
    style = now;
    last = here ? pose : std::nullopt;
  }
  flush();
  return svg;
}

/// The true pose at a time; nothing without one.
const ReportRow* row_at(const ReportCurve& curve, double time_s) {
  const auto after = std::find_if(curve.rows.begin(), curve.rows.end(), [&](const ReportRow& row) {
    return row.stamp_s >= time_s - 1e-6 && row.T_map_base_true;
  });
  return after == curve.rows.end() ? nullptr : &*after;
}

std::string map_sign(const PlotMap& map, const Eigen::Vector2d& p_map, const char* style,
                     const std::string& text, const std::string& title) {
  const Eigen::Vector2d p = map_pixel(map.grid, p_map);
  return fmt::format(
      "<text class=\"sign {}\" dy=\"0.35em\" x=\"{:.1f}\" y=\"{:.1f}\" "
      "style=\"font-size:{:.1f}px\">{}<title>{}"
      "</title></text>\n",
      style, p.x(), p.y(), 10.0 * map_stroke(map.grid), text, escape_html(title));
}

/// Where kidnaps put the robot, numbered, and where the localizer was right again.
std::string event_signs(const RunFolder& run, const ReportCurve& curve, const PlotMap& map) {
  std::string svg;
  int kidnaps = 0;
  for (const ReportEvent& event : run.events) {
    if (std::holds_alternative<KidnapEvent>(event.what)) {
      ++kidnaps;
      if (!event.T_map_to || !map.on_floor(event.to_z)) continue;
      svg += map_sign(map, event.T_map_to->translation(), "kidnapped", fmt::format("{}▼", kidnaps),
                      fmt::format("kidnap {} at {:.1f} s", kidnaps, event.stamp_s));
    }
    const bool right = std::holds_alternative<RecoveryEvent>(event.what);
    if (!right || event.localizer != curve.localizer) continue;
    const ReportRow* row = row_at(curve, event.stamp_s);
    if (row == nullptr || !map.on_floor(row->z_true)) continue;
    svg += map_sign(map, row->T_map_base_true->translation(), "regained", "✓",
                    fmt::format("right again at {:.1f} s", event.stamp_s));
  }
  return svg;
}

std::string estimate_path(const ReportCurve& curve, std::size_t style, const PlotMap& map) {
  return path_element(curve.localizer, fmt::format("path light c{}", style),
                      path_data(curve, kEstimated, map.grid, map.on_floor), map_stroke(map.grid));
}

std::string figure_html(const std::string& svg, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", svg, caption);
}

std::string caption_of(const std::string& name, const PlotMap& map) {
  return map.where.empty() ? name : fmt::format("{}, {}", name, map.where);
}

/// A map with the errors of one localizer.
std::string error_figure(const RunFolder& run, const ReportCurve& curve, std::size_t style,
                         const PlotMap& map) {
  const double stroke = map_stroke(map.grid);
  const std::string rim =
      fmt::format("<path class=\"path rim\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", 4.5 * stroke,
                  path_data(curve, kTrue, map.grid, map.on_floor));
  const std::string label = caption_of("error of " + curve.localizer + " along the path", map);
  return figure_html(map_svg(map.grid, map.drawn,
                             rim + error_paths(curve, map, stroke) +
                                 estimate_path(curve, style, map) + event_signs(run, curve, map),
                             label),
                     line_sample(style) + caption_of(escape_html(curve.localizer), map));
}

/// A map with the paths of all localizers, which nothing tells right from wrong.
std::string paths_figure(const RunFolder& run, const std::vector<std::size_t>& styles,
                         const PlotMap& map) {
  std::string paths;
  std::string names;
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    paths += estimate_path(run.curves[i], styles[i], map);
    names +=
        (names.empty() ? "" : ", ") + line_sample(styles[i]) + escape_html(run.curves[i].localizer);
  }
  return figure_html(map_svg(map.grid, map.drawn, paths, caption_of("paths on the map", map)),
                     caption_of(names, map));
}

std::string figures_on(const RunFolder& run, const PlotMap& map) {
  std::vector<std::string> names;
  for (const ReportCurve& curve : run.curves) names.push_back(curve.localizer);
  const std::vector<std::size_t> styles = localizer_styles(names);
  if (std::none_of(run.curves.begin(), run.curves.end(), has_truth)) {
    return paths_figure(run, styles, map);
  }
  std::string html;
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    html += error_figure(run, run.curves[i], styles[i], map);
  }
  return html;
}

std::string plot_of_levels(const RunFolder& run, const LevelMaps& levels) {
  std::string html;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto on_floor = [&](std::optional<double> z) {
      return level_at(levels, z.value_or(0.0)) == i;
    };
    html += figures_on(
        run, {levels[i].map, true, on_floor, fmt::format("level {}: {:.2f} m", i, levels[i].z)});
  }
  return html;
}

}  // namespace

std::string render_map_plot(const RunFolder& run, const ReportMaps& maps) {
  const auto all = [](std::optional<double>) { return true; };
  const RosMap around = maps.map ? RosMap{} : bounding_grid(run);
  const std::string figures =
      maps.levels.empty()
          ? figures_on(run, {maps.map ? *maps.map : around, maps.map.has_value(), all})
          : plot_of_levels(run, maps.levels);
  const bool scored = std::any_of(run.curves.begin(), run.curves.end(), has_truth);
  return (scored ? error_legend() : "") + "<div class=\"map-plots\">\n" + figures + "</div>\n";
}

}  // namespace castaway::testbed
