#include "recon/output/canal_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assets/theme.h"
#include "recon/output/html_report.h"

namespace odontoscope {
namespace {

constexpr double width = 760, height = 420, left = 70, right = 20, top = 76, bottom = 60;
class Plot {
 public:
  explicit Plot(const CanalExperiment& experiment) : experiment_(experiment) {
    for (const CanalResult& result : experiment.db) largest_ = std::max(largest_, static_cast<double>(result.grid));
  }

  std::string text() const {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"system-ui,sans-serif\" font-size=\"14\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"{2}\"/>\n",
        width, height, paper_);
    svg += fmt::format(
        "<text x=\"{}\" y=\"26\" font-size=\"17\">A canal of {} mm in a tooth of 10 mm: where is it still "
        "open?</text>\n",
        left, experiment_.tooth.canal);
    return svg + axes() + dt_line() + db_dots() + legend() + "</svg>\n";
  }

 private:
  double x(double grid) const { return left + (width - left - right) * grid / largest_; }
  static double y(double share) { return height - bottom - (height - top - bottom) * share; }
  double share(const CanalResult& result) const {
    return static_cast<double>(result.open_slices) / static_cast<double>(experiment_.slices);
  }

  std::string axes() const {
    std::string svg;
    for (int percent = 0; percent <= 100; percent += 25) {
      svg += fmt::format(
          "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"{6}\"/>"
          "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}%</text>\n",
          left, width - right, y(percent / 100.0), left - 8, y(percent / 100.0) + 5, percent, lines_);
    }
    const double step = std::max(1.0, std::pow(2.0, std::floor(std::log2(largest_ / 5))));
    for (double grid = step; grid <= largest_; grid += step) {
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x(grid),
                         height - bottom + 20, grid);
    }
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">grid points along x and y</text>\n",
                       (left + width - right) / 2, height - 14);
    return svg + fmt::format(
                     "<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">slices with the canal "
                     "open</text>\n",
                     (top + height - bottom) / 2);
  }

  std::string dt_line() const {
    return fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"{3}\" stroke-width=\"3\"{4}/>\n", left,
        width - right, y(share(experiment_.dt)), dt_, experiment_.dt.open_through ? "" : " stroke-dasharray=\"6 6\"");
  }

  std::string db_dots() const {
    std::string svg, line;
    for (const CanalResult& result : experiment_.db) {
      const double px = x(static_cast<double>(result.grid)), py = y(share(result));
      line += fmt::format("{:.1f},{:.1f} ", px, py);
      svg += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\" stroke=\"{}\" stroke-width=\"2\"><title>grid {}: "
          "open in {} of "
          "{} slices, genus {}, {} surfaces</title></circle>\n",
          px, py, result.open_through ? db_ : paper_, db_, result.grid, result.open_slices, experiment_.slices,
          result.genus, result.surfaces);
    }
    return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-opacity=\"0.45\"/>\n", line, db_) +
           svg;
  }

  std::string legend() const {
    constexpr double row = 46;
    return fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2}\" y2=\"{2}\" stroke=\"{3}\" stroke-width=\"3\"/><text x=\"{4}\" "
        "y=\"{5}\">DT: {6}</text>\n"
        "<circle cx=\"{7}\" cy=\"{2}\" r=\"5\" fill=\"{8}\" stroke=\"{8}\" stroke-width=\"2\"/><text x=\"{9}\" "
        "y=\"{5}\">DB, open all the way</text>\n"
        "<circle cx=\"{10}\" cy=\"{2}\" r=\"5\" fill=\"{12}\" stroke=\"{8}\" stroke-width=\"2\"/><text x=\"{11}\" "
        "y=\"{5}\">DB, closed somewhere</text>\n",
        left, left + 28, row, dt_, left + 36, row + 5,
        experiment_.dt.open_through ? "open all the way" : "closed somewhere", left + 210, db_, left + 222, left + 410,
        left + 422, paper_);
  }

  const CanalExperiment& experiment_;
  const std::string dt_ = hex_colour(assets::theme::methods::dt), db_ = hex_colour(assets::theme::methods::db),
                    paper_ = hex_colour(assets::theme::report::paper), lines_ = hex_colour(assets::theme::report::line);
  double largest_ = 1;
};

}  // namespace

std::string canal_plot(const CanalExperiment& experiment) { return Plot(experiment).text(); }

}  // namespace odontoscope
