#include "sim/world/sdf/scenery.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "sim/robot/xml_text.hpp"

namespace castaway::sim {
namespace {

/// Removes the includes below an element; how many.
int remove_scenery(TiXmlElement& parent) {
  std::vector<TiXmlElement*> unwanted;
  int removed = 0;
  for (TiXmlElement* element = parent.FirstChildElement(); element != nullptr;
       element = element->NextSiblingElement()) {
    const TiXmlElement* uri =
        element->ValueStr() == "include" ? element->FirstChildElement("uri") : nullptr;
    const bool named = uri != nullptr && uri->GetText() != nullptr;
    if (named && is_scenery(uri->GetText())) {
      unwanted.push_back(element);
    } else {
      removed += remove_scenery(*element);
    }
  }
  for (TiXmlElement* element : unwanted) parent.RemoveChild(element);
  return removed + static_cast<int>(unwanted.size());
}

}  // namespace

bool is_scenery(const std::string& uri) {
  std::string name = uri.substr(uri.find_last_of('/') + 1);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  return name == "sun" || name == "ground_plane";
}

std::optional<std::string> without_scenery(const std::string& path) {
  const auto document = parse_xml(path, read_xml_text(path));
  TiXmlElement* root = document->RootElement();
  if (root == nullptr || remove_scenery(*root) == 0) return std::nullopt;
  return xml_text_of(*document);
}

}  // namespace castaway::sim
