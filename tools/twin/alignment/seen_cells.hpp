/// How often the cells of a map were seen empty, and how often a beam ended there.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {

/// Counts of scans by cell.
class SeenCells {
 public:
  explicit SeenCells(const localization::GridFrame& frame);

  /// A beam in cells of the grid's frame.
  struct Beam {
    Eigen::Vector2d from;
    Eigen::Vector2d end;
    bool returns = false;  ///< It ended there; false: it only passed up to there.
  };
  /// Counts each cell once that the beams of a scan pass, or in which they end. The last `before`
  /// cells are not passed: they may be noise.
  void add_scan(const std::vector<Beam>& beams, double before = 1.5);

  /// The next scan; cells are counted once in each.
  void begin_scan() { ++scan_; }
  /// Counts the cell under a point. A return counts more than passing, so mark returns first.
  void mark(const Eigen::Vector2d& p_cells, bool returns);

  /// Scans that saw a return from the cell under a point, and scans that saw through it. [cells]
  [[nodiscard]] int returns(const Eigen::Vector2d& p_cells) const;
  [[nodiscard]] int passes(const Eigen::Vector2d& p_cells) const;
  /// The same by index of the grid.
  [[nodiscard]] int returns(std::size_t index) const { return returns_[index]; }
  [[nodiscard]] int passes(std::size_t index) const { return passes_[index]; }

 private:
  [[nodiscard]] std::optional<std::size_t> index_of(const Eigen::Vector2d& p_cells) const;

  localization::GridFrame frame_;
  std::vector<std::uint16_t> returns_;
  std::vector<std::uint16_t> passes_;
  std::vector<std::uint32_t> counted_;  ///< Number of the scan that counted a cell last, times two;
                                        ///< plus one for a return.
  std::uint32_t scan_ = 0;
};

}  // namespace castaway::testbed
