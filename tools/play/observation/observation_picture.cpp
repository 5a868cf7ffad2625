#include "tools/play/observation/observation_picture.hpp"

#include <algorithm>

#include "sim/render/renderer.hpp"

namespace castaway::testbed {
namespace {

constexpr int kGap = 12;  // [px]
constexpr std::uint8_t kPaper = 255;

}  // namespace

sim::Image stack_images(const std::vector<sim::Image>& images, int gap) {
  sim::Image stack;
  for (const sim::Image& image : images) {
    stack.width = image.width;
    if (!stack.pixels.empty()) {
      stack.height += gap;
      stack.pixels.insert(stack.pixels.end(), static_cast<std::size_t>(3 * gap * image.width),
                          kPaper);
    }
    stack.height += image.height;
    stack.pixels.insert(stack.pixels.end(), image.pixels.begin(), image.pixels.end());
  }
  return stack;
}

sim::Image observation_picture(const std::vector<Observation>& observations, double reach,
                               const PanelSize& size) {
  sim::Renderer renderer(size.width, size.height);
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  std::vector<sim::Image> panels;
  for (const Observation& observation : observations) {
    panels.push_back(renderer.render(observation_scene(observation, {reach, aspect})));
  }
  return stack_images(panels, kGap);
}

}  // namespace castaway::testbed
