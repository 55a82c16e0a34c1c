#include "engine/app/image_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/app/words.h"
#include "engine/picture/png.h"
#include "recon/core/base64.h"
#include "recon/output/html_report.h"

namespace odontoscope::app {
namespace {

using VerdictJson = nlohmann::ordered_json;

constexpr std::array outcomes{PictureOutcome::alike, PictureOutcome::different, PictureOutcome::missing,
                              PictureOutcome::unexpected, PictureOutcome::unreadable};

std::size_t count_of(PictureOutcome outcome, const std::vector<ComparedPicture>& pictures) {
  return static_cast<std::size_t>(std::count_if(
      pictures.begin(), pictures.end(), [&](const ComparedPicture& picture) { return picture.outcome == outcome; }));
}

VerdictJson json_of(const ComparedPicture& picture) {
  VerdictJson json{{"name", picture.name}, {"outcome", name(picture.outcome)}};
  if (picture.expected_width > 0) json["expected_size"] = {picture.expected_width, picture.expected_height};
  if (picture.actual_width > 0) json["actual_size"] = {picture.actual_width, picture.actual_height};
  if (picture.difference.same_size) {
    const ImageDifference& found = picture.difference;
    json["masked"] = picture.masked;
    json["compared"] = found.compared;
    json["pixels"] = found.pixels;
    json["share"] = found.share;
    json["largest"] = found.largest;
    json["similarity"] = found.similarity;
    if (found.box) json["box"] = {found.box->left, found.box->top, found.box->right, found.box->bottom};
  }
  if (!picture.cause.empty()) json["cause"] = picture.cause;
  if (!picture.message.empty()) json["message"] = picture.message;
  return json;
}

/// A box with room around it, so that a single pixel is seen in its surroundings; within the picture.
PixelBox with_room(const PixelBox& box, const Image& image) {
  constexpr int room = 12;
  return {std::max(0, box.left - room), std::max(0, box.top - room), std::min(image.width - 1, box.right + room),
          std::min(image.height - 1, box.bottom + room)};
}

/// Would it be seen better from near to?
bool is_small(const PixelBox& box, const Image& image) {
  constexpr int small = 3;  // thirds of each side, two of which at most: it grows by half at least
  return small * (box.right - box.left + 1) <= 2 * image.width &&
         small * (box.bottom - box.top + 1) <= 2 * image.height;
}

std::string picture_data(const Image& image) {
  const std::string png = png_bytes(image);
  return "data:image/png;base64," + base64(png);
}

}  // namespace

std::string in_words(const ComparedPicture& picture, const ImageTolerance& tolerance) {
  const ImageDifference& found = picture.difference;
  switch (picture.outcome) {
    case PictureOutcome::missing:
      return "missing: expected, and not there";
    case PictureOutcome::unexpected:
      return "unexpected: there, and nothing to compare it with" +
             (picture.message.empty() ? "" : "; " + picture.message);
    case PictureOutcome::unreadable:
      return "unreadable: " + picture.message;
    default:
      break;
  }
  if (!found.same_size)
    return fmt::format("different: {} x {} and {} x {} pixels", picture.expected_width, picture.expected_height,
                       picture.actual_width, picture.actual_height);
  if (found.compared == 0) return "different: the mask leaves nothing to compare";
  return fmt::format("{}: {} of {} pixels ({:.3f} %) differ by more than {} of 255, the most by {}; similarity {:.4f}",
                     name(picture.outcome), found.pixels, found.compared, 100 * found.share, tolerance.channel,
                     found.largest, found.similarity);
}

std::string image_verdict_text(const std::string& expected, const std::string& actual, const ImageTolerance& tolerance,
                               const std::vector<ComparedPicture>& pictures) {
  VerdictJson json{{"format", "odontoscope.image-verdict"}, {"version", 1}, {"expected", expected}, {"actual", actual}};
  json["passed"] = count_of(PictureOutcome::alike, pictures) == pictures.size();
  json["tolerance"] = {{"channel", tolerance.channel}, {"share", tolerance.share}};
  if (tolerance.similarity > -1) json["tolerance"]["similarity"] = tolerance.similarity;
  json["counts"] = {{"pictures", pictures.size()}};
  for (const PictureOutcome outcome : outcomes) json["counts"][name(outcome)] = count_of(outcome, pictures);
  json["pictures"] = VerdictJson::array();
  for (const ComparedPicture& picture : pictures) json["pictures"].push_back(json_of(picture));
  return json.dump(2, ' ', false, VerdictJson::error_handler_t::replace) + "\n";
}

std::string FailuresPage::figure(const Image& image, const std::string& caption, Shown shown) {
  if (image.rgba.empty()) return {};
  const std::string data = picture_data(image);
  bytes_ += data.size();
  return fmt::format("<figure{}><img src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
                     shown == Shown::near_to ? " class=\"near\"" : "", data, caption, caption);
}

void FailuresPage::add(const ComparedPicture& picture, const PicturesCompared& both) {
  sections_ += fmt::format("<section><h2>{}</h2>\n<p>{}</p>\n", escaped_html(picture.name),
                           escaped_html(in_words(picture, tolerance_)));
  const bool room = bytes_ < most_bytes;
  if (!room) ++without_pictures_;
  if (room) {
    const ImageDifference& found = picture.difference;
    const Image* mask = picture.masked && found.same_size ? &both.mask : nullptr;
    sections_ += "<div class=\"row\">\n" + figure(both.expected, "expected") + figure(both.actual, "actual");
    if (found.same_size) {
      const Image difference = difference_picture(both.expected, both.actual, mask);
      sections_ += figure(difference, "difference");
      if (found.box && is_small(*found.box, both.expected)) {
        const PixelBox box = with_room(*found.box, both.expected);
        sections_ +=
            "</div><div class=\"row\">\n" +
            figure(cropped(both.expected, box),
                   fmt::format("expected, from ({}, {}) to ({}, {})", box.left, box.top, box.right, box.bottom),
                   Shown::near_to) +
            figure(cropped(both.actual, box), "actual", Shown::near_to) +
            figure(cropped(difference, box), "difference", Shown::near_to);
      }
      const std::string one = picture_data(both.expected), other = picture_data(both.actual);
      bytes_ += one.size() + other.size();
      sections_ += fmt::format(
          "</div><details><summary>One over the other: drag the corner below the red line</summary><div "
          "class=\"over\"><img src=\"{}\" alt=\"actual\"><div><img src=\"{}\" alt=\"expected\">"
          "</div></div></details><div>\n",
          other, one);
    }
    sections_ += "</div>\n";
  }
  sections_ += "</section>\n";
}

std::string FailuresPage::html(const std::string& expected, const std::string& actual,
                               const std::vector<ComparedPicture>& pictures) const {
  const std::string verdict =
      fmt::format("{} of {} alike", count_of(PictureOutcome::alike, pictures), counted(pictures.size(), "picture"));
  const std::string tolerance = fmt::format(
      "no more than {:.3f} % of the pixels differ by more than {} of 255{}", 100 * tolerance_.share, tolerance_.channel,
      tolerance_.similarity > -1 ? fmt::format(", and whose similarity is at least {}", tolerance_.similarity) : "");
  const std::string left_out =
      without_pictures_ == 0
          ? ""
          : fmt::format("<p>The last {} are told in words alone: their pictures would make this page too large.</p>\n",
                        counted(without_pictures_, "failure"));
  return html_report("pictures.html", {{"verdict", verdict},
                                       {"own_style", std::string(report_file("pictures.css"))},
                                       {"expected", escaped_html(expected)},
                                       {"actual", escaped_html(actual)},
                                       {"tolerance", tolerance},
                                       {"left_out", left_out},
                                       {"pictures", sections_}});
}

}  // namespace odontoscope::app
