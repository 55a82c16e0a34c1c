// The page names every picture, and nothing that is not there.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "engine/figures/draw.h"
#include "engine/figures/figures_page.h"

namespace odontoscope::figures {
namespace {

std::vector<Figure> two_figures() {
  Figure one{1, "A <tooth>", "Caption & more", 0.75, std::vector<Panel>(2)},
      two{12, "Another", "Words", 1, std::vector<Panel>(1)};
  one.panels[0].caption = "first \"panel\"";
  return {one, two};
}

TEST(IndexPage, ShowsEachPanelWithItsWords) {
  const std::vector<Figure> figures = two_figures();
  const std::string page = index_page(figures, "About <it>.");
  for (const char* expected : {"src=\"figure-01a.png\"", "src=\"figure-01b.png\"", "src=\"figure-12.png\"",
                               "A &lt;tooth&gt;", "Caption &amp; more", "first &quot;panel&quot;", "About &lt;it&gt;.",
                               "id=\"figure-12\"", "name=\"viewport\"", "width=\"750\" height=\"1000\""})
    EXPECT_NE(page.find(expected), std::string::npos) << expected;
}

TEST(IndexPage, NeedsNothingFromElsewhere) {
  const std::string page = index_page(two_figures(), "");
  for (const char* foreign : {"http:", "https:", "<script", "url(", "@import"})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
}

TEST(PictureNames, DifferForEachPanel) {
  std::set<std::string> names;
  std::size_t panels = 0;
  for (const Figure& figure : two_figures())
    for (std::size_t i = 0; i < figure.panels.size(); ++i, ++panels) names.insert(picture_name(figure, i));
  EXPECT_EQ(names.size(), panels);
}

}  // namespace
}  // namespace odontoscope::figures
