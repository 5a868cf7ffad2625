#include "tools/outputs/pictures/map_picture.hpp"

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/outputs/pictures/palette.hpp"

namespace castaway::testbed {

MapCaption caption_of(const ScanRecord& record) {
  MapCaption caption;
  caption.clock = fmt::format("{:.1f} s", seconds(record.stamp));
  if (record.true_pose) caption.entries.push_back({"truth", 0x000000, true});
  const std::vector<std::size_t> styles = localizer_styles(record);
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    caption.entries.push_back(
        {record.localizers[i].name, palette_color(kLocalizerColors, styles[i]), false});
  }
  if (!record.people.people.empty()) caption.entries.push_back({"people", kPeopleColor, true});
  return caption;
}

sim::Image map_picture(sim::Renderer& renderer, const PictureWorld& world,
                       const sim::SceneItem& map_item, const ScanRecord& record) {
  const int width = renderer.width();
  const int height = renderer.height();
  MapCaption caption = caption_of(record);
  MapView view{static_cast<double>(width) / height, 0.0};
  // The scale bar's width depends on the scale, which depends on the number of caption lines. This
  // converges after two rounds at most.
  for (int round = 0; round < 3; ++round) {
    view.below = static_cast<double>(caption_height(caption, width, height)) / height;
    caption.pixels_per_m = height / map_height(*world.map, view);
  }
  sim::Image image = renderer.render(map_scene(world, map_item, record, view));
  draw_caption(caption, image);
  return image;
}

}  // namespace castaway::testbed
