/// Instances of people in pictures, as COCO has them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// Which pixels of a picture belong to one thing.
struct InstanceMask {
  int left = 0;    ///< [px] Of the tight box around them...
  int top = 0;     ///< [px]
  int width = 0;   ///< [px]
  int height = 0;  ///< [px]
  int area = 0;    ///< [px] How many they are.
  /// Lengths of runs that do not and do belong to it in turn, down the columns of the whole
  /// picture: COCO's run lengths, not compressed.
  std::vector<int> counts;
};

/// The mask of `instance` in a picture of `width` columns, rows from the top; nothing where it is
/// not seen.
std::optional<InstanceMask> mask_of(const std::vector<std::uint16_t>& instances, int width,
                                    std::uint16_t instance);

/// Collects pictures and the people in them. https://cocodataset.org/#format-data
class CocoFile {
 public:
  CocoFile();

  /// A picture taken at `stamp_s`; `instances` as of `mask_of`.
  void add(const std::string& file_name, double stamp_s,
           const std::vector<std::uint16_t>& instances, int width);
  /// All of it as JSON text.
  [[nodiscard]] std::string text() const;

 private:
  nlohmann::ordered_json root_;
};

}  // namespace castaway::testbed
