#include "engine/figures/page.h"

#include <fmt/format.h>

#include <string_view>

#include "engine/figures/draw.h"
#include "recon/output/html_text.h"

namespace odontoscope::figures {
namespace {

constexpr std::string_view style = R"(
:root{color-scheme:light}
body{font:17px/1.5 system-ui,sans-serif;color:#222;background:#fdfcf9;max-width:76rem;margin:0 auto;padding:1rem}
h1{font-size:1.7rem;line-height:1.2;margin:.5rem 0}
section{margin:2.6rem 0;border-top:1px solid #e2ded2;padding-top:1.2rem}
h2{font-size:1.25rem;line-height:1.3;margin:0 0 .3rem}
h2 b{color:#8a6d3b;font-weight:600;margin-right:.4rem}
p{margin:.3rem 0 1rem;max-width:48rem}
.panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(17rem,100%),1fr));gap:1rem}
figure{margin:0;min-width:0}
img{display:block;width:100%;height:auto;border:1px solid #eee9dd;border-radius:6px}
figcaption{font-size:.95rem;color:#444;margin-top:.4rem}
nav{display:flex;flex-wrap:wrap;gap:.4rem}
nav a{display:inline-block;min-width:1.6rem;padding:.3rem .5rem;text-align:center;border:1px solid #ddd6c5;border-radius:6px;color:#333;text-decoration:none}
)";

std::string section(const Figure& figure) {
  std::string html =
      fmt::format("<section id=\"figure-{0}\"><h2><b>Figure {0}</b>{1}</h2>\n<p>{2}</p>\n<div class=\"panels\">\n",
                  figure.number, escaped_html(figure.title), escaped_html(figure.caption));
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const std::string caption = escaped_html(figure.panels[i].caption);
    const PixelSize size = panel_size(figure, 1000);
    const std::string letter =
        figure.panels.size() > 1 ? fmt::format("({}) ", static_cast<char>('a' + i)) : std::string();
    html += fmt::format(
        "<figure><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" "
        "loading=\"lazy\"><figcaption>{}{}</figcaption></figure>\n",
        picture_name(figure, i), caption, size.width, size.height, letter, caption);
  }
  return html + "</div></section>\n";
}

}  // namespace

std::string index_page(const std::vector<Figure>& figures, const std::string& about) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\">\n";
  html +=
      fmt::format("<title>Two ways to make a tooth from its contours</title><style>{}</style></head><body>\n", style);
  html += fmt::format(
      "<h1>Two ways to make a tooth from its contours</h1>\n<p>The figures of a paper of the year 2000, computed anew. "
      "DT: tetrahedra of a Delaunay "
      "triangulation between neighbouring slices. DB: a distance field on a grid, and marching cubes. {}</p>\n<nav>",
      escaped_html(about));
  for (const Figure& figure : figures)
    html += fmt::format("<a href=\"#figure-{0}\" title=\"{1}\">{0}</a>", figure.number, escaped_html(figure.title));
  html += "</nav>\n";
  for (const Figure& figure : figures) html += section(figure);
  return html +
         "<p>After <i>Qualitative analysis of two reconstruction techniques and their application in dentistry</i>, "
         "Journal of Electronic Imaging "
         "9(4), 2000. Pictures and captions made by Odontoscope.</p>\n</body></html>\n";
}

}  // namespace odontoscope::figures
