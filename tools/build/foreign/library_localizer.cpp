#include "tools/build/foreign/library_localizer.hpp"

#include <dlfcn.h>
#include <elf.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/build/foreign/odometry_twist.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

/// Reads a structure; false at the end of the file.
template <typename Head>
bool read_at(std::ifstream& stream, std::uint64_t offset, Head& head) {
  stream.seekg(static_cast<std::streamoff>(offset));
  return static_cast<bool>(stream.read(reinterpret_cast<char*>(&head), sizeof(head)));
}

/// Throws std::runtime_error if a file is a 64-bit ELF file (System V ABI, chapters 4 and 5) that
/// is shorter than its segments. Other files are left to the loader.
void require_whole_library(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return;
  require_regular_file(file);
  const std::uint64_t size = std::filesystem::file_size(file);
  std::ifstream stream(file, std::ios::binary);
  Elf64_Ehdr head{};
  if (!read_at(stream, 0, head) || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0) return;
  if (head.e_ident[EI_CLASS] != ELFCLASS64) return;
  for (unsigned i = 0; i < head.e_phnum; ++i) {
    Elf64_Phdr segment{};
    const bool there = read_at(stream, head.e_phoff + i * sizeof(segment), segment);
    const std::uint64_t end = segment.p_offset + segment.p_filesz;
    if (there && end <= size && end >= segment.p_offset) continue;
    throw std::runtime_error(
        fmt::format("{}: is cut off after {} bytes; build or copy it again", file.string(), size));
  }
}

using localization::Estimate;
using localization::PopulationView;

castaway_pose c_pose(const SE2& pose) { return {pose.x, pose.y, pose.yaw}; }

SE2 se2_of(const castaway_pose& pose) { return {pose.x, pose.y, pose.yaw}; }

castaway_lidar c_lidar(const LidarFacts& lidar) {
  castaway_lidar c{};
  c.size = sizeof(c);
  c.name = lidar.name.c_str();
  for (int i = 0; i < 12; ++i) c.T_base_laser[i] = lidar.T_base_laser(i / 4, i % 4);
  c.angle_min = lidar.angle_min;
  c.angle_increment = lidar.angle_increment;
  c.range_min = lidar.range_min;
  c.range_max = lidar.range_max;
  c.beams = lidar.beams;
  return c;
}

castaway_map c_map(const Greeting& greeting) {
  const RosMap& map = greeting.map;
  castaway_map c{};
  c.size = sizeof(c);
  c.file = greeting.map_file.empty() ? nullptr : greeting.map_file.c_str();
  c.width = map.width;
  c.height = map.height;
  c.resolution = map.resolution;
  c.origin = {map.origin_x, map.origin_y, map.origin_yaw};
  c.cells = map.cells.data();
  return c;
}

castaway_estimate nothing_stated() {
  castaway_estimate c{};
  c.size = sizeof(c);
  c.probability = std::numeric_limits<double>::quiet_NaN();
  c.quality = c.probability;
  return c;
}

Answer to_answer(const castaway_estimate& c, localization::Stamp stamp) {
  Answer answer;
  for (std::size_t i = 0; c.hypotheses != nullptr && i < c.hypothesis_count; ++i) {
    PopulationView view;
    view.id = static_cast<int>(i);
    view.T_map_base = se2_of(c.hypotheses[i].pose);
    view.share = c.hypotheses[i].probability;
    answer.populations.push_back(std::move(view));
  }
  if (c.has_pose != 0) {
    Estimate& estimate = answer.estimate.emplace();
    estimate.stamp = stamp;
    estimate.T_map_base = se2_of(c.pose);
    for (int i = 0; i < 9; ++i) estimate.covariance(i / 3, i % 3) = c.covariance[i];
    estimate.probability = c.probability;
    estimate.quality = c.quality;
    estimate.lost = c.lost != 0;
  }
  complete(answer);
  return answer;
}

/// The text on one line, and not longer than a line.
std::string line_of(const char* text) {
  constexpr std::size_t kLongest = 200;
  std::string line = text == nullptr || *text == '\0' ? "failed without saying why" : text;
  if (line.size() > kLongest) line = line.substr(0, kLongest) + " ...";
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return line;
}

/// What helps if the loader lacks versions of symbols, which newer C and C++ libraries have.
std::string loading_remedy(const std::string& error) {
  if (error.find("version `") == std::string::npos) return "";
  return "; it was built with newer libraries of C or C++ than castaway runs with: build it on an "
         "older system, C++ with -static-libstdc++ -static-libgcc";
}

/// A name without a slash would be looked for in the system's folders only.
std::string library_path(const LibraryConfig& config) {
  const std::string found = find_beside(config.library, config.folder);
  return found.find('/') == std::string::npos ? "./" + found : found;
}

const castaway_localizer_functions& functions_of(void* library, const std::string& file) {
  using Get = const castaway_localizer_functions* (*)();
  const auto get = reinterpret_cast<Get>(dlsym(library, "castaway_localizer"));
  if (get == nullptr) {
    throw std::runtime_error(file + ": has no function castaway_localizer (castaway/localizer.h)");
  }
  const castaway_localizer_functions* functions = get();
  if (functions == nullptr) throw std::runtime_error(file + ": castaway_localizer() returns NULL");
  if (functions->version != CASTAWAY_LOCALIZER_VERSION) {
    throw std::runtime_error(
        fmt::format("{}: has version {} of the interface, and this castaway version {}; build it "
                    "with this castaway's castaway/localizer.h",
                    file, functions->version, CASTAWAY_LOCALIZER_VERSION));
  }
  const bool complete = functions->size >= sizeof(castaway_localizer_functions) &&
                        functions->create != nullptr && functions->destroy != nullptr &&
                        functions->initialize != nullptr && functions->on_odometry != nullptr &&
                        functions->on_scan != nullptr && functions->error != nullptr;
  if (!complete)
    throw std::runtime_error(file + ": its table lacks functions of castaway/localizer.h");
  return *functions;
}

}  // namespace

void LibraryLocalizer::Close::operator()(void* library) const { dlclose(library); }

LibraryLocalizer::LibraryLocalizer(const LibraryConfig& config, const Greeting& greeting) {
  const std::string file = library_path(config);
  require_whole_library(file);
  library_.reset(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!library_) {
    const std::string error = line_of(dlerror());
    throw std::runtime_error("cannot load the library: " + error + loading_remedy(error));
  }
  functions_ = &functions_of(library_.get(), file);
  std::vector<castaway_lidar> lidars;
  for (const LidarFacts& lidar : greeting.lidars) lidars.push_back(c_lidar(lidar));
  castaway_setup setup{};
  setup.size = sizeof(setup);
  setup.name = greeting.name.c_str();
  setup.seed = greeting.seed;
  setup.map = c_map(greeting);
  setup.lidars = lidars.data();
  setup.lidar_count = lidars.size();
  setup.params = config.params.c_str();
  localizer_ = {functions_->create(&setup), Destroy{functions_->destroy}};
  if (!localizer_) throw std::runtime_error(file + ": " + line_of(functions_->error(nullptr)));
}

void LibraryLocalizer::require(int result) const {
  if (result == 0) return;
  throw LocalizerFailure(line_of(functions_->error(localizer_.get())));
}

void LibraryLocalizer::initialize(const std::optional<localization::PoseWithCovariance>& start) {
  answer_ = {};
  if (!start) {
    require(functions_->initialize(localizer_.get(), nullptr));
    return;
  }
  castaway_start known{};
  known.size = sizeof(known);
  known.pose = c_pose(start->T_map_base);
  for (int i = 0; i < 9; ++i) known.covariance[i] = start->covariance(i / 3, i % 3);
  require(functions_->initialize(localizer_.get(), &known));
}

void LibraryLocalizer::on_odometry(const Odometry& odometry) {
  const Eigen::Vector3d twist = twist_between(before_, odometry);
  before_ = odometry;
  const castaway_odometry reading{sizeof(castaway_odometry),
                                  odometry.stamp.count(),
                                  c_pose(odometry.T_odom_base),
                                  {twist.x(), twist.y(), twist.z()}};
  require(functions_->on_odometry(localizer_.get(), &reading));
}

void LibraryLocalizer::on_scan(const LaserScan& scan) {
  const LidarFacts facts = lidar_facts(scan);
  const castaway_lidar lidar = c_lidar(facts);
  const castaway_scan reading{sizeof(castaway_scan), scan.stamp.count(),
                              scan.time_increment.count(), &lidar, scan.ranges.data()};
  castaway_estimate estimate = nothing_stated();
  require(functions_->on_scan(localizer_.get(), &reading, &estimate));
  try {
    answer_ = to_answer(estimate, scan.stamp);
  } catch (const std::invalid_argument& error) {
    throw LocalizerFailure(error.what());
  }
}

std::optional<Estimate> LibraryLocalizer::estimate() const { return answer_.estimate; }

localization::Diagnostics LibraryLocalizer::diagnostics() const {
  localization::Diagnostics diagnostics;
  diagnostics.populations = answer_.populations;
  return diagnostics;
}

}  // namespace castaway::testbed
