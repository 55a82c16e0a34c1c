#include "recon/output/comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "assets/theme.h"
#include "recon/core/base64.h"
#include "recon/output/html_report.h"

namespace odontoscope {
namespace {

constexpr std::array colours{assets::theme::methods::dt, assets::theme::methods::db, assets::theme::methods::decimated};

std::string head_cells(const Comparison& comparison) {
  std::string cells;
  for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
    cells += fmt::format("<th style=\"color:{}\">{}</th>", hex_colour(colours[i % 3]),
                         escaped_html(comparison.methods[i].name));
  }
  return cells;
}

std::string main_table(const Comparison& comparison) {
  std::string html = fmt::format("<table><thead><tr><th></th>{}</tr></thead><tbody>\n", head_cells(comparison));
  for (const ComparisonRow& row : comparison_rows(comparison)) {
    html += fmt::format("<tr><td>{}</td>", escaped_html(row.what));
    for (const std::string& value : row.values) html += fmt::format("<td>{}</td>", escaped_html(value));
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string distance_table(const Comparison& comparison) {
  std::string html =
      "<table><thead><tr><th>A and B</th><th>mean, A to B</th><th>largest, A to B</th><th>mean, B to "
      "A</th><th>largest, B "
      "to A</th></tr></thead><tbody>\n";
  for (const ComparedPair& pair : comparison.pairs) {
    const SurfaceDistance& d = pair.distance;
    html += fmt::format("<tr><td>{} and {}</td><td>{:.4g}</td><td>{:.4g}</td><td>{:.4g}</td><td>{:.4g}</td></tr>\n",
                        escaped_html(comparison.methods[pair.first].name),
                        escaped_html(comparison.methods[pair.second].name), d.a_to_b.mean, d.a_to_b.largest,
                        d.b_to_a.mean, d.b_to_a.largest);
  }
  return html + "</tbody></table>\n";
}

/// Share of triangles by smallest angle, one bar a bin.
std::string angle_chart(const ComparedMethod& method, const std::string& colour) {
  const Distribution& angles = method.report.smallest_angle_deg;
  std::size_t all = 0, most = 1;
  for (const std::size_t count : angles.histogram) {
    all += count;
    most = std::max(most, count);
  }
  constexpr double chart_width = 320, chart_height = 150, base = 120;
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"smallest angles of {}\">\n",
                                chart_width, chart_height, escaped_html(method.name));
  const double bar = chart_width / static_cast<double>(std::max<std::size_t>(angles.histogram.size(), 1));
  for (std::size_t i = 0; i < angles.histogram.size(); ++i) {
    const double tall = (base - 20) * static_cast<double>(angles.histogram[i]) / static_cast<double>(most);
    const double percent = all > 0 ? 100.0 * static_cast<double>(angles.histogram[i]) / static_cast<double>(all) : 0;
    const double x = bar * static_cast<double>(i);
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" chart_width=\"{:.1f}\" chart_height=\"{:.1f}\" fill=\"{}\"/>",
                       x + 2, base - tall, bar - 4, tall, colour);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" text-anchor=\"middle\">{:.0f}%</text>",
                       x + bar / 2, base - tall - 4, percent);
    const double from = angles.histogram_low + (angles.histogram_high - angles.histogram_low) * static_cast<double>(i) /
                                                   static_cast<double>(angles.histogram.size());
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" font-size=\"10\" text-anchor=\"middle\">{:.0f}</text>\n", x + 6,
                       base + 14, from);
  }
  return svg + fmt::format(
                   "<text x=\"{}\" y=\"{}\" font-size=\"11\" text-anchor=\"middle\">smallest angle of a triangle, "
                   "degrees</text></svg>\n",
                   chart_width / 2, chart_height - 3);
}

std::string charts(const Comparison& comparison) {
  std::string html = "<div class=\"row\">\n";
  for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
    html += fmt::format("<figure>{}", angle_chart(comparison.methods[i], hex_colour(colours[i % 3])));
    const ComparedMethod& method = comparison.methods[i];
    html +=
        fmt::format("<figcaption>{}: {}{}</figcaption></figure>\n", escaped_html(method.name),
                    escaped_html(method.made_by), method.verdict.empty() ? "" : "<br>" + escaped_html(method.verdict));
  }
  return html + "</div>\n";
}

std::string pictures(const Comparison& comparison) {
  std::size_t most = 0;
  for (const ComparedMethod& method : comparison.methods) most = std::max(most, method.pictures.size());
  if (most == 0) return {};
  std::string html = "<h2>Pictures</h2>\n";
  for (std::size_t n = 0; n < most; ++n) {
    html += "<div class=\"row\">\n";
    for (const ComparedMethod& method : comparison.methods) {
      if (n >= method.pictures.size()) continue;
      const MethodPicture& picture = method.pictures[n];
      html += fmt::format(
          "<figure><img alt=\"{}\" src=\"data:image/png;base64,{}\"><figcaption>{}: {}</figcaption></figure>\n",
          escaped_html(picture.caption), base64(picture.png), escaped_html(method.name), escaped_html(picture.caption));
    }
    html += "</div>\n";
  }
  return html;
}

}  // namespace

std::string comparison_page(const Comparison& comparison) {
  const std::string made_from = fmt::format(
      "{} slices, {} contours, {} points. DB: grid of {} x {} points in {} layers, field {}, table {}. {} thread{}.",
      comparison.slices, comparison.contours, comparison.points, comparison.grid.columns, comparison.grid.rows,
      comparison.grid.layers.size(), name(comparison.field), name(comparison.cases), comparison.threads,
      comparison.threads == 1 ? "" : "s");
  return html_report("comparison.html",
                     {{"title", comparison.source.empty() ? "contours" : escaped_html(comparison.source)},
                      {"made_from", made_from},
                      {"table", main_table(comparison)},
                      {"pictures", pictures(comparison)},
                      {"distances", distance_table(comparison)},
                      {"charts", charts(comparison)}});
}

}  // namespace odontoscope
