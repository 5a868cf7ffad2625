#include "sim/world/sdf/include_check.hpp"

#include <map>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "sim/robot/xml_text.hpp"
#include "sim/world/sdf/scenery.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxDepth = 20;
constexpr int kMaxInclusions = 5000;

class IncludeCheck {
 public:
  explicit IncludeCheck(const ResourceFinder& finder) : finder_(finder) {}

  void visit(const fs::path& file) {
    for (const fs::path& open : open_) {
      if (open == file) fail(file, "it includes itself; break the circle");
    }
    if (open_.size() >= kMaxDepth) fail(file, "models are nested more than 20 levels deep");
    open_.push_back(file);
    for (const std::string& uri : includes_of(file)) {
      if (++inclusions_ > kMaxInclusions) fail(file, "more than 5000 models are included");
      visit(finder_.model_file(found(uri, file)));
    }
    open_.pop_back();
  }

 private:
  [[noreturn]] static void fail(const fs::path& file, const std::string& why) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
  }

  [[nodiscard]] fs::path found(const std::string& uri, const fs::path& file) const {
    try {
      return finder_.find(uri, file.parent_path());
    } catch (const std::runtime_error& error) {
      fail(file, std::string("<include>: ") + error.what());
    }
  }

  /// URIs of the file's includes, anywhere in it.
  const std::vector<std::string>& includes_of(const fs::path& file) {
    const auto known = includes_.find(file);
    if (known != includes_.end()) return known->second;
    std::vector<std::string>& uris = includes_[file];
    const auto document = parse_xml(file.string(), read_xml_text(file.string()));
    collect(*document, uris);
    return uris;
  }

  static void collect(const TiXmlNode& node, std::vector<std::string>& uris) {
    for (const TiXmlElement* element = node.FirstChildElement(); element != nullptr;
         element = element->NextSiblingElement()) {
      const TiXmlElement* uri =
          element->ValueStr() == "include" ? element->FirstChildElement("uri") : nullptr;
      const bool named = uri != nullptr && uri->GetText() != nullptr;
      if (named && !is_scenery(uri->GetText())) uris.emplace_back(uri->GetText());
      collect(*element, uris);
    }
  }

  const ResourceFinder& finder_;
  std::vector<fs::path> open_;
  std::map<fs::path, std::vector<std::string>> includes_;
  int inclusions_ = 0;
};

}  // namespace

void check_includes(const fs::path& world, const ResourceFinder& finder) {
  IncludeCheck(finder).visit(fs::weakly_canonical(world));
}

}  // namespace castaway::sim
