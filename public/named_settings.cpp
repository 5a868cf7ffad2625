#include "public/named_settings.hpp"

namespace castaway {

testbed::YamlDocument settings_document(const std::string& who, const NamedSettings& settings) {
  testbed::YamlNode root;
  root.kind = testbed::YamlNode::Kind::kMap;
  root.where = who;
  for (const auto& [key, value] : settings) {
    const std::string where = fmt::format("{}: {}={}", who, key, value);
    put_value(root, key, testbed::parse_yaml(value, where), where);
  }
  return testbed::YamlDocument(std::move(root));
}

}  // namespace castaway
