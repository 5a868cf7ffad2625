#include "tools/pages/html/html_page.hpp"

#include <fmt/format.h>

#include "tools/base/formats/html.hpp"

namespace castaway::testbed {
namespace {

/// Content of a `<style>` element. Colours of localizers (c0 to c5) are those of palette.hpp,
/// those of errors (e0 to e5) follow error_scale.hpp; both are brighter on dark ground.
inline constexpr const char* kReportStyle = R"(
:root { color-scheme: light; --page: #fbfbfa; --ink: #1d2328; --soft: #59636d; --line: #d9dde0; --card: #ffffff;
  --mark: #8a3ffc; --link: #0b5c8f; --good: #00724f; --bad: #c1272d; --warn: #b36b00; --warn-text: #8f5500;
  --free: #ffffff; --wall: #23292e; --unknown: #d5d9dc; --scan: #d0103a; --person: #5b6670;
  --c0: #0072B2; --c1: #D55E00; --c2: #009E73; --c3: #CC79A7; --c4: #E69F00; --c5: #56B4E9;
  --e0: #1f4e9c; --e1: #4a90c9; --e2: #86c5e0; --e3: #f2b134; --e4: #e2611a; --e5: #a3123a; }
:root[data-theme="dark"] { color-scheme: dark; --page: #14181b; --ink: #e6e9eb; --soft: #9fabb5; --line: #343c43;
  --card: #1c2226; --mark: #be95ff; --link: #7cc4f2; --good: #4fd6a4; --bad: #ff7b72; --warn: #f0b04f; --warn-text: #f0b04f;
  --free: #262d33; --wall: #e2e6e9; --unknown: #14181b; --scan: #ff5d7d; --person: #9aa6b0;
  --c0: #4fa8e0; --c1: #f0843c; --c2: #2fc79a; --c3: #e39cc4; --c4: #f0c25a; --c5: #9ad4f5;
  --e0: #5b8fe6; --e1: #7db8e8; --e2: #b3dff0; --e3: #ffd166; --e4: #ff8a4c; --e5: #ff4d6d; }
@media (prefers-color-scheme: dark) { :root:not([data-theme="light"]) { color-scheme: dark; --page: #14181b; --ink: #e6e9eb;
  --soft: #9fabb5; --line: #343c43; --card: #1c2226; --mark: #be95ff; --link: #7cc4f2; --good: #4fd6a4; --bad: #ff7b72;
  --warn: #f0b04f; --warn-text: #f0b04f; --free: #262d33; --wall: #e2e6e9; --unknown: #14181b; --scan: #ff5d7d;
  --person: #9aa6b0; --c0: #4fa8e0; --c1: #f0843c; --c2: #2fc79a; --c3: #e39cc4; --c4: #f0c25a; --c5: #9ad4f5;
  --e0: #5b8fe6; --e1: #7db8e8; --e2: #b3dff0; --e3: #ffd166; --e4: #ff8a4c; --e5: #ff4d6d; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1180px; padding: 1.2rem; background: var(--page); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; margin: 0.3rem 0; overflow-wrap: anywhere; } h2 { font-size: 1.2rem; margin: 2rem 0 0.6rem; }
a { color: var(--link); }
p { margin: 0.4rem 0; } .soft { color: var(--soft); font-size: 0.9rem; }
.lead p { font-size: 1.08rem; }
.wide { overflow-x: auto; } table { border-collapse: collapse; min-width: 60%; }
.figures { max-width: 1560px; } .figures th { white-space: normal; vertical-align: bottom; }
.figures .wide { font-size: 0.88rem; } .figures .wide th, .figures .wide td { padding: 0.25rem 0.5rem; }
.figures .wide td:first-child { position: sticky; left: 0; background: var(--page); white-space: normal; min-width: 8rem; }
.figures .wide td { white-space: normal; min-width: 5rem; }
th, td { text-align: right; padding: 0.25rem 0.8rem; border-bottom: 1px solid var(--line); white-space: nowrap;
  font-variant-numeric: tabular-nums; }
th:first-child, td:first-child { text-align: left; } tr.group th { padding-top: 0.9rem; color: var(--soft); font-weight: 600; }
svg { display: block; width: 100%; height: auto; background: var(--card); border: 1px solid var(--line); border-radius: 6px; }
svg.map { max-height: 80vh; } svg text { fill: var(--soft); font: 11px system-ui, sans-serif; }
.grid { stroke: var(--line); stroke-width: 1; } .path { fill: none; stroke-linejoin: round; }
.path.rim { stroke: #fff; } .scale { fill: none; stroke: var(--soft); }
.c0 { stroke: var(--c0); } .c1 { stroke: var(--c1); stroke-dasharray: 8 4; } .c2 { stroke: var(--c2); stroke-dasharray: 2 3; }
.c3 { stroke: var(--c3); stroke-dasharray: 10 3 2 3; } .c4 { stroke: var(--c4); stroke-dasharray: 14 5; }
.c5 { stroke: var(--c5); stroke-dasharray: 5 2 1 2; }
.light.c0 { stroke: #0072B2; } .light.c1 { stroke: #D55E00; } .light.c2 { stroke: #009E73; }
.light.c3 { stroke: #CC79A7; } .light.c4 { stroke: #E69F00; } .light.c5 { stroke: #56B4E9; }
.e0 { stroke: #1f4e9c; } .e1 { stroke: #4a90c9; } .e2 { stroke: #86c5e0; } .e3 { stroke: #f2b134; } .e4 { stroke: #e2611a; }
.e5 { stroke: #a3123a; } .unscored { stroke: #8a9299; }
svg .sign { font-weight: 700; text-anchor: middle; paint-order: stroke; stroke: #fff; stroke-width: 0.25em; }
svg .sign.kidnapped { fill: #8a3ffc; text-anchor: end; } svg .sign.regained { fill: #00724f; text-anchor: start; }
svg .band { opacity: 0.14; stroke: none; } svg.chart { max-width: 900px; } svg.chart text { font-size: 13px; }
.bad { color: var(--bad); font-weight: 600; } li.unmet { color: var(--bad); } td small { color: var(--soft); }
.map-plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(440px, 100%), 1fr)); gap: 0.8rem; }
.even { stroke: var(--soft); fill: var(--card); } .better { stroke: var(--good); fill: var(--good); }
.worse { stroke: var(--bad); fill: var(--bad); } .bar { stroke-dasharray: none; }
.legend { display: flex; flex-wrap: wrap; gap: 0.2rem 1.2rem; margin: 0.4rem 0; font-size: 0.92rem; }
svg.sample { display: inline-block; width: 26px; height: 10px; border: 0; background: none; vertical-align: middle; margin-right: 0.4rem; }
.sample line { stroke-width: 3; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); gap: 0.8rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; border-radius: 6px; border: 1px solid var(--line); }
pre { overflow-x: auto; margin: 0.4rem 0; padding: 0.6rem 0.8rem; background: var(--card); border: 1px solid var(--line);
  border-radius: 6px; font-size: 0.85rem; line-height: 1.4; } summary { cursor: pointer; }
figcaption { font-size: 0.85rem; color: var(--soft); }
@media (max-width: 700px) {
  body { padding: 0.7rem; } th, td { padding: 0.2rem 0.35rem; } th, td { white-space: normal; } tr.group th { text-align: left; }
  table.stack, .stack tbody, .stack tr, .stack td { display: block; } .stack thead { display: none; }
  .stack td { display: flex; justify-content: space-between; gap: 1rem; border: 0; overflow-wrap: anywhere; }
  .stack td:empty { display: none; } .stack td:first-child { font-weight: 600; } .stack td[data-head]::before { content: attr(data-head); color: var(--soft); }
  .stack tr { border-bottom: 1px solid var(--line); padding: 0.3rem 0; }
  .bars text { font-size: 16px; } svg.chart text { font-size: 22px; } }
)";

constexpr const char* kPolicy =
    "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src "
    "'unsafe-inline'";

}  // namespace

std::string html_page(const HtmlPage& page) {
  const std::string script =
      page.bundle ? fmt::format("<script>{}</script>\n", page.bundle->script) : "";
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>castaway: {}</title><style>{}{}{}</style></head>\n<body class=\"{}\">\n"
      "<main>\n{}</main>\n{}</body></html>\n",
      std::string(kPolicy) + (page.talks ? "; connect-src 'self'" : ""), escape_html(page.title),
      kReportStyle, page.style, page.bundle ? page.bundle->style : "", page.body_class, page.body,
      script);
}

std::string html_section(const std::string& title, const std::string& body) {
  return fmt::format("<section><h2>{}</h2>\n{}</section>\n", escape_html(title), body);
}

}  // namespace castaway::testbed
