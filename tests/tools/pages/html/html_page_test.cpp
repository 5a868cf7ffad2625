#include "tools/pages/html/html_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(HtmlPage, IsWholeAndLoadsNothing) {
  const std::string html = html_page({.title = "a <b>", .body = "<p>text</p>", .style = "p {}"});
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
  EXPECT_TRUE(contains(html, "<title>castaway: a &lt;b&gt;</title>"));
  EXPECT_TRUE(contains(html, "content=\"default-src 'none'; "));
  EXPECT_TRUE(contains(html, "p {}</style>"));
  EXPECT_FALSE(contains(html, "<script>"));
  EXPECT_TRUE(html.ends_with("<p>text</p></main>\n</body></html>\n"));
}

TEST(HtmlPage, RunsItsScriptAfterTheBody) {
  const std::string html = html_page({.body = "text", .bundle = WebBundle{"run()", "i {}"}});
  EXPECT_TRUE(contains(html, "i {}</style>"));
  EXPECT_TRUE(html.ends_with("text</main>\n<script>run()</script>\n</body></html>\n"));
}

TEST(HtmlSection, EscapesItsTitle) {
  EXPECT_EQ(html_section("a & b", "<p>c</p>"), "<section><h2>a &amp; b</h2>\n<p>c</p></section>\n");
  EXPECT_EQ(html_section("caf\xe9", ""), "<section><h2>caf\xef\xbf\xbd</h2>\n</section>\n");
}

}  // namespace
}  // namespace castaway::testbed
