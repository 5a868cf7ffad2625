// Fuzzes images of maps, up to the fields that a localizer derives from them.

#include <optional>
#include <stdexcept>

#include "localization/mh_amcl/mh_amcl.hpp"
#include "tests/fuzz/fuzz_input.hpp"
#include "tools/base/formats/images/gray_image.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/map_conversion.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway;
  try {
    const testbed::GrayImage image = testbed::load_gray_image(testbed::as_file(data, size, ".pgm"));
    if (image.pixels.size() > 1000000) return 0;  // Large images are valid but slow.
    const testbed::RosMap map = testbed::make_ros_map(image, {}, "fuzz");
    localization::MhAmcl({}, testbed::to_occupancy_grid(map), 1).initialize(std::nullopt);
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
