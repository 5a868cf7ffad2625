#include "tools/base/formats/volume/stance_texts.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace castaway::testbed {
namespace {

constexpr const char* kWheels = "wheels";
constexpr const char* kCentre = "centre_of_mass";

std::vector<double> numbers_in(const std::string& name, const std::string& text) {
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number = 0.0; words >> number;) numbers.push_back(number);
  const bool whole =
      words.eof() && std::ranges::all_of(numbers, [](double n) { return std::isfinite(n); });
  if (!whole) {
    throw std::runtime_error("record 'run', " + name + ": '" + text + "' are not numbers");
  }
  return numbers;
}

}  // namespace

Texts texts_of(const localization::WheelStance& wheels) {
  if (!wheels.is_known()) return {};
  std::vector<double> contacts;
  for (const Eigen::Vector2d& p : wheels.contacts()) {
    contacts.insert(contacts.end(), {p.x(), p.y()});
  }
  const Eigen::Vector3d& com = wheels.p_base_com();
  return {{kWheels, fmt::format("{}", fmt::join(contacts, " "))},
          {kCentre, fmt::format("{} {} {}", com.x(), com.y(), com.z())}};
}

localization::WheelStance wheels_in(const Texts& texts) {
  const auto wheels = texts.find(kWheels);
  const auto centre = texts.find(kCentre);
  if (wheels == texts.end() || centre == texts.end()) return {};
  const std::vector<double> xy = numbers_in(kWheels, wheels->second);
  const std::vector<double> com = numbers_in(kCentre, centre->second);
  if (xy.size() % 2 != 0 || com.size() != 3) {
    throw std::runtime_error("record 'run': wheels need x and y each, centre_of_mass x, y and z");
  }
  std::vector<Eigen::Vector2d> contacts;
  for (std::size_t i = 0; i < xy.size(); i += 2) contacts.emplace_back(xy[i], xy[i + 1]);
  return {std::move(contacts), {com[0], com[1], com[2]}};
}

}  // namespace castaway::testbed
