#include "engine/figures/figures_page.h"

#include <fmt/format.h>

#include "engine/figures/draw.h"
#include "recon/output/html_report.h"

namespace odontoscope::figures {
namespace {

std::string section(const Figure& figure) {
  std::string html =
      fmt::format("<section id=\"figure-{0}\"><h2><b>Figure {0}</b>{1}</h2>\n<p>{2}</p>\n<div class=\"row\">\n",
                  figure.number, escaped_html(figure.title), escaped_html(figure.caption));
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const std::string caption = escaped_html(figure.panels[i].caption);
    const PixelSize pixels = panel_size(figure, 1000);
    const std::string letter =
        figure.panels.size() > 1 ? fmt::format("({}) ", static_cast<char>('a' + i)) : std::string();
    html += fmt::format(
        "<figure><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" "
        "loading=\"lazy\"><figcaption>{}{}</figcaption></figure>\n",
        picture_name(figure, i), caption, pixels.width, pixels.height, letter, caption);
  }
  return html + "</div></section>\n";
}

}  // namespace

std::string index_page(const std::vector<Figure>& figures, const std::string& about) {
  std::string numbers, sections;
  for (const Figure& figure : figures) {
    numbers += fmt::format("<a href=\"#figure-{0}\" title=\"{1}\">{0}</a>", figure.number, escaped_html(figure.title));
    sections += section(figure);
  }
  return html_report("figures.html", {{"about", escaped_html(about)}, {"numbers", numbers}, {"figures", sections}});
}

}  // namespace odontoscope::figures
