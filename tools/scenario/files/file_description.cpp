#include "tools/scenario/files/file_description.hpp"

#include <algorithm>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

/// Lines of "# ..." before the content, joined.
std::string yaml_comment(const std::string& text) {
  std::string comment;
  for (std::size_t from = 0; from < text.size() && text[from] == '#';) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::size_t words = text.find_first_not_of("# ", from);
    if (words < end) comment += (comment.empty() ? "" : " ") + text.substr(words, end - words);
    from = end + 1;
  }
  return comment;
}

/// The first `<!-- ... -->`, if no element precedes it but `<?xml ...?>`.
std::string xml_comment(const std::string& text) {
  const std::size_t declared = text.starts_with("<?") ? text.find("?>") + 2 : 0;
  const std::size_t begin = text.find_first_not_of(" \t\r\n", declared);
  if (begin == std::string::npos || text.compare(begin, 4, "<!--") != 0) return "";
  const std::size_t words = text.find_first_not_of(" \t\r\n", begin + 4);
  if (words == std::string::npos) return "";
  return text.substr(words, text.find("-->", begin) - words);
}

}  // namespace

std::string first_sentence(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  std::string comment = text.starts_with("#") ? yaml_comment(text) : xml_comment(text);
  const std::size_t stop = comment.find(". ");
  if (stop != std::string::npos) comment.resize(stop);
  const std::size_t last = comment.find_last_not_of(". \t\r\n");
  comment.resize(last == std::string::npos ? 0 : last + 1);
  for (char& c : comment) c = c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
  return comment;
}

std::string shorten(const std::string& text, std::size_t most) {
  constexpr std::size_t kMark = 4;  // " ..."
  if (text.size() <= most) return text;
  const std::size_t space = text.rfind(' ', most - kMark);
  std::string cut = text.substr(0, space == std::string::npos ? most - kMark : space);
  while (cut.ends_with(',') || cut.ends_with(':') || cut.ends_with(';')) cut.pop_back();
  return cut + " ...";
}

}  // namespace castaway::testbed
