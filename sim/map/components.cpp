#include "sim/map/components.hpp"

#include <algorithm>

namespace castaway::sim {

Components::Components(const Grid& grid) : labels_(grid.cells.size(), -1) {
  const auto width = static_cast<std::size_t>(grid.width);
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (grid.cells[i] != Cell::kFree) continue;
    const int left = i % width > 0 ? labels_[i - 1] : -1;
    const int below = i >= width ? labels_[i - width] : -1;
    labels_[i] = left >= 0 ? left : below >= 0 ? below : new_run();
    if (left >= 0 && below >= 0 && left != below) join(left, below);
  }
  number();
}

int Components::largest() const {
  return static_cast<int>(std::max_element(sizes_.begin(), sizes_.end()) - sizes_.begin());
}

int Components::new_run() {
  first_.push_back(static_cast<int>(first_.size()));
  return first_.back();
}

/// The first run of a run's component.
int Components::root(int run) {
  const auto at = [this](int i) -> int& { return first_[static_cast<std::size_t>(i)]; };
  while (at(run) != run) {
    at(run) = at(at(run));  // Halves the path for later calls.
    run = at(run);
  }
  return run;
}

void Components::join(int a, int b) {
  a = root(a);
  b = root(b);
  first_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

/// Numbers the components and turns the labels from runs into components.
void Components::number() {
  std::vector<int> component(first_.size(), -1);
  for (std::size_t run = 0; run < first_.size(); ++run) {
    const auto first = static_cast<std::size_t>(root(static_cast<int>(run)));
    if (first == run) {
      component[run] = static_cast<int>(sizes_.size());
      sizes_.push_back(0);
    } else {
      component[run] = component[first];
    }
  }
  for (int& label : labels_) {
    if (label < 0) continue;
    label = component[static_cast<std::size_t>(label)];
    ++sizes_[static_cast<std::size_t>(label)];
  }
}

}  // namespace castaway::sim
