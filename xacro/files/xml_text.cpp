#include "xacro/files/xml_text.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "xacro/files/git_lfs.hpp"

namespace castaway {
namespace {

constexpr std::size_t kMaxBytes = 16U << 20U;
constexpr int kMaxDepth = 200;
constexpr int kMaxElements = 200000;
// Per element: the parser compares each attribute with all others.
constexpr int kMaxAttributes = 1000;

/// Checks the markup without building a tree.
class Guard {
 public:
  Guard(const std::string& path, const std::string& text) : path_(path), text_(text) {}

  void check() {
    if (is_git_lfs_pointer(text_)) refuse(std::string(kGitLfsPointer));
    if (text_.find('\0') != std::string::npos) refuse("holds a zero byte: not a text file");
    while ((at_ = text_.find('<', at_)) != std::string::npos) {
      if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>")) continue;
      if (text_.compare(at_, 2, "<!") == 0) {
        refuse("document types and entities (<!DOCTYPE>, <!ENTITY>) are not read: remove them");
      }
      tag();
    }
  }

 private:
  bool skip(std::string_view open, std::string_view close) {
    if (text_.compare(at_, open.size(), open) != 0) return false;
    const std::size_t end = text_.find(close, at_ + open.size());
    at_ = end == std::string::npos ? text_.size() : end + close.size();
    return true;
  }

  /// Position of the tag's closing bracket, outside of quotes; counts the attributes.
  [[nodiscard]] std::size_t tag_end() const {
    char quote = 0;
    int attributes = 0;
    std::size_t end = at_ + 1;
    for (; end < text_.size(); ++end) {
      const char c = text_[end];
      if (quote == 0 && c == '>') break;
      if (c == quote) {
        quote = 0;
      } else if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
        if (++attributes > kMaxAttributes) {
          refuse(fmt::format("an element has more than {} attributes", kMaxAttributes));
        }
      }
    }
    return end;
  }

  void tag() {
    const bool closes = at_ + 1 < text_.size() && text_[at_ + 1] == '/';
    const std::size_t end = tag_end();
    const bool empty = end < text_.size() && text_[end - 1] == '/';
    if (!closes && ++elements_ > kMaxElements) {
      refuse(fmt::format("more than {} elements: not a robot", kMaxElements));
    }
    if (!empty) depth_ += closes ? -1 : 1;
    if (depth_ > kMaxDepth) refuse(fmt::format("elements nested deeper than {}", kMaxDepth));
    at_ = std::min(end + 1, text_.size());
  }

  [[noreturn]] void refuse(const std::string& why) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
    throw std::runtime_error(
        fmt::format("{}:{}: {}", path_, 1 + std::count(text_.begin(), end, '\n'), why));
  }

  const std::string& path_;
  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int elements_ = 0;
};

}  // namespace

std::string read_xml_text(const std::string& path) {
  std::error_code none;
  const bool is_file = std::filesystem::is_regular_file(path, none);
  if (is_file && std::filesystem::file_size(path, none) > kMaxBytes) {
    throw std::runtime_error(
        fmt::format("{}: larger than {} MiB: not a robot's description", path, kMaxBytes >> 20U));
  }
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  if (!is_file || !file || !(text << file.rdbuf())) {
    throw std::runtime_error(fmt::format(
        "{}: cannot read this robot: check that the path names a URDF or xacro file", path));
  }
  return text.str();
}

std::unique_ptr<TiXmlDocument> parse_xml(const std::string& path, const std::string& text) {
  Guard(path, text).check();
  auto document = std::make_unique<TiXmlDocument>();
  document->Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document->Error()) {
    throw std::runtime_error(fmt::format("{}:{}: not well-formed XML: {}", path,
                                         document->ErrorRow(), document->ErrorDesc()));
  }
  if (document->RootElement() == nullptr) {
    throw std::runtime_error(fmt::format("{}: not an XML file: it holds no element", path));
  }
  return document;
}

std::string xml_text_of(const TiXmlDocument& document) {
  TiXmlPrinter printer;
  printer.SetIndent("  ");
  document.Accept(&printer);
  return printer.Str();
}

std::string attribute(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? "" : value;
}

}  // namespace castaway
