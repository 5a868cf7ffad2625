#include "sim/world/sdf/include_check.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/world/sdf/scenery.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxIncludeDepth = 20;
constexpr int kMaxInclusions = 5000;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw std::length_error(fmt::format("{}: {}", file.string(), why));
}

/// Collects the URIs of an element's includes, at all depths.
void collect(const TiXmlNode& node, std::vector<std::string>& uris) {
  if (const TiXmlElement* self = node.ToElement(); self != nullptr) {
    const TiXmlElement* uri =
        self->ValueStr() == "include" ? self->FirstChildElement("uri") : nullptr;
    const bool named = uri != nullptr && uri->GetText() != nullptr;
    if (named && !is_scenery(uri->GetText())) uris.emplace_back(uri->GetText());
  }
  for (const TiXmlElement* element = node.FirstChildElement(); element != nullptr;
       element = element->NextSiblingElement()) {
    collect(*element, uris);
  }
}

/// Removes the file from the list of open files at the end of its scope, also when an exception is
/// thrown.
class OpenFile {
 public:
  OpenFile(std::vector<fs::path>& open, const fs::path& file) : open_(open) {
    open_.push_back(file);
  }
  ~OpenFile() { open_.pop_back(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

 private:
  std::vector<fs::path>& open_;
};

}  // namespace

void IncludeCheck::follow(const TiXmlNode& element) {
  std::vector<std::string> uris;
  collect(element, uris);
  for (const std::string& uri : uris) visit(uri);
}

void IncludeCheck::visit(const std::string& uri) {
  const fs::path from = open_.back();
  if (++inclusions_ > kMaxInclusions) refuse(from, "more than 5000 models are included");
  const fs::path file = finder_.model_file(finder_.find(uri, from.parent_path()));
  if (std::find(open_.begin(), open_.end(), file) != open_.end()) {
    refuse(file, "it includes itself; remove the circular include");
  }
  if (open_.size() >= kMaxIncludeDepth) refuse(file, "models are nested more than 20 levels deep");
  const OpenFile opened(open_, file);
  for (const std::string& next : includes_of(file)) visit(next);
}

const std::vector<std::string>& IncludeCheck::includes_of(const fs::path& file) {
  const auto known = includes_.find(file);
  if (known != includes_.end()) return known->second;
  std::vector<std::string> uris;
  collect(*parse_xml(file.string(), read_xml_text(file.string())), uris);
  return includes_[file] = std::move(uris);
}

}  // namespace castaway::sim
