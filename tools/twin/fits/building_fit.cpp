#include "tools/twin/fits/building_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/twin/alignment/beam_view.hpp"
#include "tools/twin/alignment/seen_cells.hpp"
#include "tools/twin/fits/grid_boxes.hpp"

namespace castaway::testbed {
namespace {

constexpr double kNearest = 1.5;  // [m] A robot that waits for people sees them closer.
constexpr std::size_t kFittedScans = 1500;

/// Where something stands that is not on the map: most of the scans that saw the cell saw a return.
bool stands_at(const SeenCells& seen, const Eigen::Vector2d& p_cells) {
  constexpr int kFewest = 4;
  int returns = 0;
  int passes = 0;
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      const Eigen::Vector2d p = p_cells + Eigen::Vector2d(dx, dy);
      returns = std::max(returns, seen.returns(p));
      if (dx == 0 && dy == 0) passes = seen.passes(p);
    }
  }
  return returns >= kFewest && 2 * returns > passes;
}

/// Sums of the beams of some scans.
struct Tally {
  double beams = 0.0;
  double moving = 0.0;
  double standing = 0.0;
  double through = 0.0;
  double objects = 0.0;  ///< Moving ones within `kWatched`.
  double area_m2 = 0.0;  ///< Seen within `kWatched`.
  double scans = 0.0;

  void add(const Tally& other) {
    beams += other.beams;
    moving += other.moving;
    standing += other.standing;
    through += other.through;
    objects += other.objects;
    area_m2 += other.area_m2;
    scans += other.scans;
  }
};

/// Counts groups of moving returns: neighbouring beams whose ends are less than a stride apart.
class ObjectCounter {
 public:
  explicit ObjectCounter(double resolution) : resolution_(resolution) {}

  void add(const BeamView& view) {
    if (view.range_m < kNearest || view.range_m > BuildingFit::kWatched) return;
    if (sizes_.empty() || !are_close(view.end, last_)) sizes_.push_back(0);
    if (sizes_.size() == 1 && sizes_.back() == 0) first_ = view.end;
    ++sizes_.back();
    last_ = view.end;
  }
  /// Groups of at least two returns. The last one is also the first if a circle closes in it.
  [[nodiscard]] int count() const {
    std::vector<int> sizes = sizes_;
    if (sizes.size() > 1 && are_close(first_, last_)) {
      sizes.front() += sizes.back();
      sizes.pop_back();
    }
    constexpr int kFewest = 2;
    return static_cast<int>(
        std::count_if(sizes.begin(), sizes.end(), [](int size) { return size >= kFewest; }));
  }

 private:
  static constexpr double kStride = 0.7;  // [m]

  [[nodiscard]] bool are_close(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    return (a - b).norm() * resolution_ < kStride;
  }

  double resolution_;
  Eigen::Vector2d first_ = Eigen::Vector2d::Zero();  ///< End of the first beam,
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();   ///< and of the last one.
  std::vector<int> sizes_;                           ///< Beams of each group.
};

/// Adds the ends of beams at moving things to `moving`. [cells]
Tally tally_scan(const std::vector<BeamView>& views, const SeenCells& seen, double resolution,
                 std::vector<Eigen::Vector2d>& moving) {
  Tally tally;
  tally.scans = 1.0;
  ObjectCounter objects(resolution);
  for (const BeamView& view : views) {
    tally.beams += 1.0;
    const double r = std::clamp(view.range_m, kNearest, BuildingFit::kWatched);
    tally.area_m2 += 0.5 * (r * r - kNearest * kNearest) * view.turn_rad;
    if (view.through) tally.through += 1.0;
    if (!view.foreign) continue;
    if (stands_at(seen, view.end)) {
      tally.standing += 1.0;
    } else {
      tally.moving += 1.0;
      moving.push_back(view.end);
      objects.add(view);
    }
  }
  tally.objects = objects.count();
  return tally;
}

/// At most 2000 points, evenly spread. `cells`: [cells] in the grid. [m] In map.
std::vector<Eigen::Vector2d> some_points(const localization::GridFrame& frame,
                                         const std::vector<Eigen::Vector2d>& cells) {
  std::vector<Eigen::Vector2d> points;
  for (const std::size_t i : localization::even_indices(cells.size(), 2000)) {
    points.push_back(frame.T_map_grid * Eigen::Vector2d(frame.resolution * cells[i]));
  }
  return points;
}

/// Cells of free space where something stands.
std::vector<char> standing_cells(const AlignedLog& log, const SeenCells& returns) {
  constexpr int kFewest = 4;
  std::vector<char> marked(log.grid.frame.size());
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (returns.returns(i) >= kFewest && 2 * returns.returns(i) > returns.passes(i)) marked[i] = 1;
  }
  return marked;
}

/// Wall cells that most of the scans saw through. `walls`: returns are scans that saw through a
/// wall's cell, passes those that saw its surface.
std::vector<char> gone_cells(const AlignedLog& log, const SeenCells& walls) {
  constexpr int kFewest = 4;
  std::vector<char> marked(log.grid.frame.size());
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (walls.returns(i) >= kFewest && walls.returns(i) > 2 * walls.passes(i)) marked[i] = 1;
  }
  return marked;
}

void mark_walls(const std::vector<BeamView>& views, SeenCells& walls) {
  walls.begin_scan();
  for (const BeamView& view : views) {
    if (view.through) walls.mark(view.wall, true);
  }
  for (const BeamView& view : views) {
    if (view.confirms) walls.mark(view.wall, false);
  }
}

/// Beams of a scan as seen cells. Foreign returns count as returns.
std::vector<SeenCells::Beam> foreign_beams(const std::vector<BeamView>& views) {
  std::vector<SeenCells::Beam> beams;
  for (const BeamView& view : views) beams.push_back({view.from, view.end, view.foreign});
  return beams;
}

}  // namespace

std::optional<BuildingFit> fit_building(const AlignedLog& log) {
  const BeamViewer viewer(log);
  const double resolution = log.grid.frame.resolution;
  SeenCells seen(log.grid.frame);
  const std::vector<std::size_t> indices = spread_scans(log, kFittedScans);
  SeenCells walls(log.grid.frame);
  for (const std::size_t i : indices) {
    const std::vector<BeamView> views = viewer.view(log.scans[i]);
    seen.add_scan(foreign_beams(views));
    mark_walls(views, walls);
  }
  std::array<Tally, Blocks::kCount> blocks;
  std::vector<Eigen::Vector2d> moving;
  for (const std::size_t i : indices) {
    blocks[i * Blocks::kCount / log.scans.size()].add(
        tally_scan(viewer.view(log.scans[i]), seen, resolution, moving));
  }
  BuildingFit fit;
  fit.free_area_m2 = connected_area(log);
  const auto total = [&](std::size_t left_out) {
    Tally sum;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      if (k != left_out) sum.add(blocks[k]);
    }
    return sum;
  };
  const Tally all = total(Blocks::kCount);
  if (all.beams == 0.0 || all.area_m2 == 0.0) return std::nullopt;
  const std::vector<Figure> figures = jackknife([&](std::size_t left_out) {
    const Tally sum = total(left_out);
    const double beams = std::max(sum.beams, 1.0);
    return std::vector{sum.moving / beams, sum.standing / beams, sum.through / beams,
                       sum.objects / std::max(sum.area_m2, 1e-9) * fit.free_area_m2};
  });
  fit.moving_share = figures[0];
  fit.standing_share = figures[1];
  fit.through_share = figures[2];
  fit.moving_count = figures[3];
  fit.watched_m2 = all.area_m2 / all.scans;
  fit.beams = static_cast<std::size_t>(all.beams);
  fit.moving_at = some_points(log.grid.frame, moving);
  fit.standing = box_groups(log.grid.frame, standing_cells(log, seen), 2);
  fit.gone = box_groups(log.grid.frame, gone_cells(log, walls), 2);
  return fit;
}

}  // namespace castaway::testbed
