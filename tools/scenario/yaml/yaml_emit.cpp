#include <fmt/format.h>

#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {
namespace {

using Kind = YamlNode::Kind;

/// Whether every YAML reader takes the unquoted text as this string.
bool is_plain(const std::string& text) {
  constexpr std::string_view kSafe =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-";
  if (text == "null" || text == "Null" || text == "NULL") return false;
  const bool dash = text == "-" || text == "---" || text.starts_with("- ");
  return !text.empty() && !dash && text.find_first_not_of(kSafe) == std::string::npos;
}

std::string quote_scalar(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string scalar_text(const std::string& text) {
  return is_plain(text) ? text : quote_scalar(text);
}

bool all_scalars(const YamlNode& list) {
  for (const YamlNode& item : list.items) {
    if (item.kind != Kind::kScalar) return false;
  }
  return true;
}

/// The node on the line of its key; empty if it needs lines of its own.
std::string inline_text(const YamlNode& node) {
  if (node.kind == Kind::kNull) return "~";
  if (node.kind == Kind::kScalar) return scalar_text(node.scalar);
  if (node.kind == Kind::kMap) return node.entries.empty() ? "{}" : "";
  if (!all_scalars(node)) return "";
  std::string text = "[";
  for (const YamlNode& item : node.items) {
    if (text.size() > 1) text += ", ";
    text += scalar_text(item.scalar);
  }
  return text + "]";
}

void emit_block(const YamlNode& node, const std::string& indent, std::string& out);

void emit_value(const std::string& head, const YamlNode& value, const std::string& indent,
                std::string& out) {
  const std::string text = inline_text(value);
  out += head;
  if (!text.empty()) {
    out += " " + text + "\n";
    return;
  }
  out += "\n";
  emit_block(value, indent + "  ", out);
}

void emit_block(const YamlNode& node, const std::string& indent, std::string& out) {
  for (const YamlEntry& entry : node.entries) {
    emit_value(indent + scalar_text(entry.key) + ":", entry.value, indent, out);
  }
  for (const YamlNode& item : node.items) emit_value(indent + "-", item, indent, out);
}

}  // namespace

std::string emit_yaml(const YamlNode& root) {
  const std::string text = inline_text(root);
  if (!text.empty()) return text + "\n";
  std::string out;
  emit_block(root, "", out);
  return out;
}

}  // namespace castaway::testbed
