#include "localization/map/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace castaway::localization {
namespace {

constexpr double kFar = 1e12;

/// One pass of the distance transform along a line: `out[q] = min over p of (q - p)^2 + f[p]`.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(std::size_t longest) : vertex_(longest), border_(longest + 1) {}

  void transform(const std::vector<double>& f, std::vector<double>& out, std::size_t n) {
    std::size_t k = 0;
    vertex_[0] = 0;
    border_[0] = -std::numeric_limits<double>::infinity();
    border_[1] = std::numeric_limits<double>::infinity();
    for (std::size_t q = 1; q < n; ++q) {
      double s = crossing(f, q, vertex_[k]);
      while (s <= border_[k]) s = crossing(f, q, vertex_[--k]);
      vertex_[++k] = q;
      border_[k] = s;
      border_[k + 1] = std::numeric_limits<double>::infinity();
    }
    k = 0;
    for (std::size_t q = 0; q < n; ++q) {
      while (border_[k + 1] < static_cast<double>(q)) ++k;
      const double d = static_cast<double>(q) - static_cast<double>(vertex_[k]);
      out[q] = d * d + f[vertex_[k]];
    }
  }

 private:
  /// Intersection of the parabolas with vertices at q and p < q.
  static double crossing(const std::vector<double>& f, std::size_t q, std::size_t p) {
    const double dq = static_cast<double>(q);
    const double dp = static_cast<double>(p);
    return ((f[q] + dq * dq) - (f[p] + dp * dp)) / (2.0 * (dq - dp));
  }
  std::vector<std::size_t> vertex_;
  std::vector<double> border_;
};

/// Transforms `lines` lines of `length` cells that start `line_stride` apart and step by `stride`.
struct Pass {
  std::size_t lines, line_stride, length, stride;
};

void run(const Pass& pass, std::vector<double>& squared) {
  LowerEnvelope envelope(pass.length);
  std::vector<double> in(pass.length);
  std::vector<double> out(pass.length);
  for (std::size_t line = 0; line < pass.lines; ++line) {
    double* first = squared.data() + line * pass.line_stride;
    for (std::size_t i = 0; i < pass.length; ++i) in[i] = first[i * pass.stride];
    envelope.transform(in, out, pass.length);
    for (std::size_t i = 0; i < pass.length; ++i) first[i * pass.stride] = out[i];
  }
}

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid, double max_distance)
    : frame_(grid.frame), max_distance_(max_distance), values_(grid.frame.size()) {
  validate(grid);
  std::vector<double> squared(frame_.size());
  std::transform(grid.cells.begin(), grid.cells.end(), squared.begin(),
                 [](CellState cell) { return cell == CellState::kOccupied ? 0.0 : kFar; });
  const auto width = static_cast<std::size_t>(frame_.width);
  const auto height = static_cast<std::size_t>(frame_.height);
  run({width, 1, height, width}, squared);
  run({height, width, width, 1}, squared);
  std::transform(squared.begin(), squared.end(), values_.begin(), [&](double d2) {
    return static_cast<float>(std::min(std::sqrt(d2) * frame_.resolution, max_distance_));
  });
}

double DistanceField::at(const Eigen::Vector2d& p_grid) const {
  const Eigen::Vector2i cell = frame_.cell_of(p_grid);
  return frame_.contains(cell) ? static_cast<double>(values_[frame_.index(cell)]) : max_distance_;
}

}  // namespace castaway::localization
