#include "recon/segmentation/dicom_common.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "recon/input/character_set.h"

namespace odontoscope {
namespace {

struct Identity {
  std::uint32_t tag;
  std::string_view vr;
  std::size_t longest;  // characters
};
constexpr std::array<Identity, 10> identity{{{0x00080020, "DA", 8},
                                             {0x00080030, "TM", 14},
                                             {0x00080050, "SH", 16},
                                             {0x00080090, "PN", 64},
                                             {0x00081030, "LO", 64},
                                             {0x00100010, "PN", 64},
                                             {0x00100020, "LO", 64},
                                             {0x00100030, "DA", 8},
                                             {0x00100040, "CS", 16},
                                             {0x00200010, "SH", 16}}};
/// Which a study may not lack, empty as they may be; the description may.
constexpr std::uint32_t study_description = 0x00081030;

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// The first `count` characters of UTF-8.
std::string first_characters(std::string text, std::size_t count) {
  std::size_t seen = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (continues_character(text[at]) || seen++ < count) continue;
    text.resize(at);
    break;
  }
  return text;
}

bool is_made_of(std::string_view text, std::string_view letters) {
  return text.find_first_not_of(letters) == text.npos;
}

/// As it may be written, or empty.
std::string tamed(const std::string& text, const Identity& what, const std::string& character_set) {
  constexpr std::string_view digits = "0123456789";
  if (what.vr == "DA") return text.size() == what.longest && is_made_of(text, digits) ? text : "";
  if (what.vr == "TM") return text.size() <= what.longest && is_made_of(text, "0123456789.") ? text : "";
  if (what.vr == "CS")
    return text.size() <= what.longest && is_made_of(text, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 _") ? text : "";
  std::string utf8 = to_utf8(text, character_set).utf8;
  std::replace(utf8.begin(), utf8.end(), '\\', '/');
  return first_characters(std::move(utf8), what.longest);
}

std::string known_uid(const std::string& uid, const std::string& otherwise) { return is_uid(uid) ? uid : otherwise; }

}  // namespace

ObjectUids object_uids(const PatientOrigin& origin, const DerivedUid& content) {
  const DicomOrigin none;
  const DicomOrigin& dicom = origin.dicom ? *origin.dicom : none;
  return {content.of("instance"), content.of("series"), known_uid(dicom.study, content.of("study")),
          known_uid(dicom.frame_of_reference, content.of("frame"))};
}

DicomWriter common_modules(const PatientOrigin& origin, const ObjectUids& uids, const std::string& class_uid,
                           const std::string& modality, const WrittenBy& by) {
  DicomWriter data;
  const DicomOrigin none;
  const DicomOrigin& dicom = origin.dicom ? *origin.dicom : none;
  for (const Identity& what : identity) {
    const auto found = dicom.identity.find(what.tag);
    const std::string value = found == dicom.identity.end() ? "" : tamed(found->second, what, dicom.character_set);
    if (!value.empty() || what.tag != study_description) data.text(what.tag, what.vr, value);
  }
  data.text(0x00080005, "CS", "ISO_IR 192")
      .text(0x00080016, "UI", class_uid)
      .text(0x00080018, "UI", uids.instance)
      .text(0x00080060, "CS", modality);
  data.text(0x00080070, "LO", "Odontoscope")
      .text(0x0008103e, "LO", "Odontoscope")
      .text(0x00081090, "LO", "Odontoscope")
      .text(0x00181020, "LO", by.program);
  data.text(0x0020000d, "UI", uids.study).text(0x0020000e, "UI", uids.series).text(0x00200011, "IS", "1");
  const Identity indicator{0x00201040, "LO", 64};
  data.text(0x00200052, "UI", uids.frame_of_reference)
      .text(indicator.tag, indicator.vr, tamed(dicom.position_indicator, indicator, dicom.character_set));
  return data;
}

std::string in_bytes(const PatientOrigin& origin) {
  std::string bytes;
  for (const auto& axis : origin.frame.axes) bytes += decimal_strings({axis[0], axis[1], axis[2]}) + '\n';
  bytes += decimal_strings({origin.frame.fixed[0], origin.frame.fixed[1], origin.frame.fixed[2]}) + '\n';
  if (!origin.dicom) return bytes;
  const DicomOrigin& dicom = *origin.dicom;
  for (const auto& [tag, value] : dicom.identity) bytes += fmt::format("{:08x} {}\n", tag, value);
  bytes += dicom.character_set + '\n' + dicom.study + '\n' + dicom.series + '\n' + dicom.frame_of_reference + '\n';
  for (const DicomInstance& instance : dicom.instances) bytes += fmt::format("{} {}\n", instance.uid, instance.frame);
  return bytes;
}

DicomWriter code_item(const Code& code) {
  return DicomWriter()
      .text(0x00080100, "SH", std::string(code.value))
      .text(0x00080102, "SH", std::string(code.scheme))
      .text(0x00080104, "LO", std::string(code.meaning));
}

DicomWriter image_item(const DicomInstance& instance) {
  DicomWriter item;
  item.text(0x00081150, "UI", instance.class_uid).text(0x00081155, "UI", instance.uid);
  if (instance.frame > 0) item.text(0x00081160, "IS", std::to_string(instance.frame));
  return item;
}

std::string content_date(const PatientOrigin& origin) {
  const Identity& date = identity.front();
  if (origin.dicom) {
    const auto found = origin.dicom->identity.find(date.tag);
    if (found != origin.dicom->identity.end()) {
      if (std::string value = tamed(found->second, date, {}); !value.empty()) return value;
    }
  }
  return "20000101";
}

std::vector<std::string> dicom_names(const std::vector<std::string>& names) {
  constexpr std::size_t longest = 64;
  std::vector<std::string> result;
  std::set<std::string> taken;
  for (std::string name : names) {
    std::replace(name.begin(), name.end(), '\\', '/');
    std::string own = first_characters(name, longest);
    for (std::size_t n = 2; !taken.insert(own).second; ++n) {
      const std::string mark = fmt::format(" ({})", n);
      own = first_characters(name, longest - mark.size()) + mark;
    }
    result.push_back(own);
  }
  return result;
}

ImagePlanes::ImagePlanes(const PatientOrigin& origin) : origin_(origin) {
  if (!origin.dicom || !origin.dicom->normal) return;
  normal_ = *origin.dicom->normal;
  const auto& z = origin.frame.axes[2];
  constexpr double parallel = 1 - 1e-6;  // 0.08 degrees: what headers round away
  if (std::abs(normal_[0] * z[0] + normal_[1] * z[1] + normal_[2] * z[2]) < parallel) return;
  for (const DicomInstance& instance : origin.dicom->instances) {
    if (instance.position && is_uid(instance.uid) && is_uid(instance.class_uid))
      by_height_.emplace_back(height(*instance.position), &instance);
  }
  std::stable_sort(by_height_.begin(), by_height_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  constexpr double share = 0.05, of_one_image = 0.01;  // mm
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < by_height_.size(); ++i) {
    if (const double gap = by_height_[i].first - by_height_[i - 1].first; gap > 0) least = std::min(least, gap);
  }
  tolerance_ = least == std::numeric_limits<double>::max() ? of_one_image : share * least;
}

double ImagePlanes::height(const std::array<double, 3>& p) const {
  return p[0] * normal_[0] + p[1] * normal_[1] + p[2] * normal_[2];
}

const DicomInstance* ImagePlanes::at(const Point3& at) const {
  if (by_height_.empty()) return nullptr;
  const Point3 p = origin_.frame.in_patient(at);
  const double own = height({p.x, p.y, p.z});
  const auto above = std::lower_bound(by_height_.begin(), by_height_.end(), own - tolerance_,
                                      [](const auto& a, double h) { return a.first < h; });
  const DicomInstance* best = nullptr;
  double nearest = tolerance_;
  for (auto one = above; one != by_height_.end() && one->first <= own + tolerance_; ++one) {
    if (best != nullptr && std::abs(one->first - own) >= nearest) continue;
    best = one->second;
    nearest = std::abs(one->first - own);
  }
  return best;
}

}  // namespace odontoscope
