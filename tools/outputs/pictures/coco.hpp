/// Masks of people in images, in COCO format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// Pixels of an image that belong to one instance.
struct InstanceMask {
  int left = 0;    ///< [px] Left edge of the tight bounding box.
  int top = 0;     ///< [px]
  int width = 0;   ///< [px]
  int height = 0;  ///< [px]
  int area = 0;    ///< [px] Number of pixels.
  /// Uncompressed COCO run lengths: alternating lengths of runs outside and inside the mask, column
  /// by column over the whole image.
  std::vector<int> counts;
};

/// Mask of `instance` in an image of `width` columns, rows from the top; nothing if it is not
/// visible.
std::optional<InstanceMask> mask_of(const std::vector<std::uint16_t>& instances, int width,
                                    std::uint16_t instance);

/// Collects images and the people in them. https://cocodataset.org/#format-data
class CocoFile {
 public:
  CocoFile();

  /// Adds an image taken at `stamp_s`; `instances` as for `mask_of`.
  void add(const std::string& file_name, double stamp_s,
           const std::vector<std::uint16_t>& instances, int width);
  /// The whole file as JSON text.
  [[nodiscard]] std::string text() const;

 private:
  nlohmann::ordered_json root_;
};

}  // namespace castaway::testbed
