#include "recon/exchange/read_rtstruct.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "recon/core/limits.h"
#include "recon/exchange/dicom_set.h"
#include "recon/exchange/limits.h"
#include "recon/exchange/parallel_planes.h"
#include "recon/exchange/repeated_contours.h"
#include "recon/exchange/unbridge.h"
#include "recon/formats/parsing.h"
#include "recon/input/character_set.h"
#include "recon/input/counts.h"

namespace odontoscope {
namespace {

using namespace parsing;

constexpr std::string_view structure_set_class = "1.2.840.10008.5.1.4.1.1.481.3";
constexpr std::size_t preamble = 128;
struct Roi {
  std::string name;
  std::map<std::string, std::size_t> left_out;  // types, and how many contours of them
  std::size_t taken = 0;
};

class StructureSetReader {
 public:
  StructureSetReader(std::string_view bytes, const std::string& file, const std::vector<std::string>& wanted)
      : set_(bytes, file), wanted_(wanted) {
    whole_.file = file;
  }

  FileContours read() {
    read_names();
    read_origin();
    read_outlines();
    refuse_unknown();
    result_.stack.source = whole_.file;
    make_slices();
    make_remarks();
    return std::move(result_);
  }

 private:
  void read_names() {
    std::map<std::string, std::size_t> times;
    for (const DicomSet::DataSet& item : set_.items(set_.top(), dicom::roi_sequence)) {
      std::string name = name_of(item);
      const std::string number(set_.text(item, dicom::roi_number));
      if (name.empty()) name = "ROI " + plain(number);
      if (const std::size_t n = ++times[name]; n > 1) name = fmt::format("{} ({})", name, n);
      by_number_.emplace(number, rois_.size());
      rois_.push_back({name, {}, 0});
      if (rois_.size() > limits::structures)
        refuse("too-many-structures", whole_, fmt::format("more than {} regions", limits::structures), {});
    }
    if (rois_.empty())
      refuse("unreadable-structure-set", whole_, "it names no region of interest",
             "Check that it is the file you mean");
  }

  void read_origin() {
    const DicomSet::DataSet top = set_.top();
    for (const std::uint32_t tag : dicom::identity) {
      if (const std::string_view text = set_.text(top, tag); !text.empty()) origin_->identity.emplace(tag, text);
    }
    origin_->character_set = set_.text(top, dicom::character_set);
    origin_->study = set_.text(top, dicom::study_uid);
    origin_->position_indicator = set_.text(top, dicom::position_indicator);
    origin_->frame_of_reference = set_.text(top, dicom::frame_of_reference);
    for (const DicomSet::DataSet& frame : set_.items(top, dicom::referenced_frames)) {
      if (const std::string_view uid = set_.text(frame, dicom::frame_of_reference); !uid.empty())
        origin_->frame_of_reference = uid;
      for (const DicomSet::DataSet& study : set_.items(frame, dicom::referenced_studies)) {
        for (const DicomSet::DataSet& series : set_.items(study, dicom::referenced_study_series)) {
          if (origin_->series.empty()) origin_->series = set_.text(series, dicom::series_uid);
        }
      }
    }
    for (const DicomSet::DataSet& roi : set_.items(top, dicom::roi_sequence)) {
      if (origin_->frame_of_reference.empty())
        origin_->frame_of_reference = set_.text(roi, dicom::roi_frame_of_reference);
    }
    result_.patient.dicom = origin_;
  }

  /// The images that a contour was drawn on; the first contour of each tells where it lies.
  void add_instances(const DicomSet::DataSet& item, const Point3& at) {
    for (const DicomSet::DataSet& image : set_.items(item, dicom::contour_images)) {
      DicomInstance instance{std::string(set_.text(image, dicom::referenced_class)),
                             std::string(set_.text(image, dicom::referenced_instance)), 0,
                             std::array{at.x, at.y, at.z}};
      double frame = 0;
      constexpr double most = 1e6;
      if (parse_number(set_.text(image, dicom::referenced_frame), frame) && frame >= 1 && frame <= most)
        instance.frame = static_cast<std::uint32_t>(frame);
      if (!instance.uid.empty() && known_instances_.emplace(instance.uid, instance.frame).second)
        origin_->instances.push_back(std::move(instance));
    }
  }

  /// In UTF-8, cut at a whole character.
  std::string name_of(const DicomSet::DataSet& item) {
    const DecodedText decoded = to_utf8(set_.text(item, dicom::roi_name).substr(0, 4 * limits::name_length),
                                        set_.text(set_.top(), dicom::character_set));
    if (decoded.guessed && !guess_told_) {
      result_.remarks.push_back(
          "names are not in the character set that the file states; they were read as UTF-8, or else as Latin-1");
      guess_told_ = true;
    }
    std::string name = decoded.utf8;
    if (name.size() <= limits::name_length) return name;
    std::size_t end = limits::name_length;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
    name.resize(end);
    return name;
  }

  static std::string plain(std::string_view name) {
    std::string result;
    for (const char c : name.substr(0, limits::name_length))
      result += static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~' ? '?' : c;
    return result;
  }

  bool is_wanted(const std::string& name) const {
    return wanted_.empty() || std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end();
  }

  void read_outlines() {
    const std::vector<DicomSet::DataSet> of_all = set_.items(set_.top(), dicom::contours_by_roi);
    if (of_all.empty())
      refuse("unreadable-structure-set", whole_, "it holds no contours", "Check that it is the file you mean");
    for (const DicomSet::DataSet& of_roi : of_all) {
      const auto roi = by_number_.find(std::string(set_.text(of_roi, dicom::referenced_roi)));
      if (roi == by_number_.end())
        refuse("unreadable-structure-set", whole_, "contours of a region that has no name", "Export it again");
      if (!is_wanted(rois_[roi->second].name)) {
        rois_[roi->second].taken = set_.items(of_roi, dicom::contour_sequence).size();  // for the list of those there
        continue;
      }
      std::size_t number = 0;
      for (const DicomSet::DataSet& item : set_.items(of_roi, dicom::contour_sequence))
        add_outline(item, roi->second, number++);
    }
  }

  void add_outline(const DicomSet::DataSet& item, std::size_t structure, std::size_t number) {
    Roi& roi = rois_[structure];
    const std::string type = plain(set_.text(item, dicom::geometric_type));
    if (type != "CLOSED_PLANAR" && type != "CLOSEDPLANAR_XOR") {
      ++roi.left_out[type.empty() ? "no type" : type];
      return;
    }
    ++roi.taken;
    Outline outline{roi.name, number, {}};
    const std::string what = fmt::format("contour {} of {}", number, roi.name);
    const std::vector<double> numbers = decimals(set_.text(item, dicom::contour_data), what);
    const std::string_view said = set_.text(item, dicom::point_count);
    if (numbers.size() % 3 != 0 || (!said.empty() && said != std::to_string(numbers.size() / 3))) {
      refuse("wrong-count", whole_,
             fmt::format("{} says that it has {} points, and holds {} numbers", what, plain(said), numbers.size()),
             "Export it again");
    }
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      outline.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
      const std::string_view fault = coordinate_fault(outline.points.back());
      if (!fault.empty()) refuse(fault, whole_, fmt::format("{} has a point without usable coordinates", what));
    }
    check_point_count(points_ += outline.points.size(), whole_);
    check_contour_count(outlines_.size() + 1, whole_);
    if (outline.points.empty()) return;
    add_instances(item, outline.points.front());
    outlines_.push_back(std::move(outline));
  }

  /// Separated by backslashes.
  std::vector<double> decimals(std::string_view list, const std::string& what) const {
    std::vector<double> numbers;
    while (!list.empty()) {
      std::string_view word = list.substr(0, list.find('\\'));
      list.remove_prefix(std::min(word.size() + 1, list.size()));
      while (!word.empty() && is_space(word.front())) word.remove_prefix(1);
      while (!word.empty() && is_space(word.back())) word.remove_suffix(1);
      double value = 0;
      if (!parse_number(word, value)) {
        refuse("unparsable", whole_,
               fmt::format("{} has \"{}\" where a number should be", what, tame(word.substr(0, limits::quoted_length))),
               "Export it again");
      }
      numbers.push_back(value);
    }
    return numbers;
  }

  void refuse_unknown() const {
    for (const std::string& wanted : wanted_) {
      const auto is_it = [&](const Roi& roi) { return roi.name == wanted; };
      const auto roi = std::find_if(rois_.begin(), rois_.end(), is_it);
      if (roi != rois_.end() && roi->taken > 0) continue;
      std::vector<std::string> there;
      for (const Roi& known : rois_) {
        if (known.taken > 0) there.push_back(known.name);
      }
      refuse("unknown-structure", whole_,
             roi == rois_.end() ? fmt::format("there is no region {}", wanted)
                                : fmt::format("{} has no closed contour", wanted),
             fmt::format("Those there are {}", fmt::join(there, ", ")));
    }
  }

  void make_slices() {
    result_.stack.slices = slices_of(outlines_, whole_, result_.remarks, result_.patient.frame);
    origin_->normal = result_.patient.frame.axes[2];
    std::size_t keyholes = 0;
    for (Slice& slice : result_.stack.slices) keyholes += part_keyholes(slice);
    if (keyholes > 0)
      result_.remarks.push_back(
          keyholes == 1
              ? "1 contour that goes along a bridge and comes back on it (a keyhole) was parted into outline and holes"
              : fmt::format("{} contours that go along a bridge and come back on it (keyholes) were parted into "
                            "outlines and holes",
                            keyholes));
    std::map<std::string, Repeats> of_structure;
    for (Slice& slice : result_.stack.slices) drop_repeats(slice, of_structure);
    for (const auto& [structure, repeats] : of_structure) {
      const std::string count = repeats.count == 1 ? "a contour was" : fmt::format("{} contours were", repeats.count);
      result_.remarks.push_back(fmt::format("{}: {} there again, the first at z = {:.6g}; each is kept once", structure,
                                            count, repeats.first_z));
    }
  }

  static std::size_t part_keyholes(Slice& slice) {
    std::size_t keyholes = 0;
    std::vector<Contour> parted;
    for (Contour& contour : slice.contours) {
      std::vector<std::vector<Point2>> rings = without_bridges(contour.points);
      if (rings.size() < 2) {
        parted.push_back(std::move(contour));
        continue;
      }
      ++keyholes;
      for (std::vector<Point2>& ring : rings) parted.push_back({contour.structure, std::move(ring)});
    }
    slice.contours = std::move(parted);
    return keyholes;
  }

  struct Repeats {
    std::size_t count = 0;
    double first_z = 0;
  };
  static void drop_repeats(Slice& slice, std::map<std::string, Repeats>& of_structure) {
    const std::vector<std::size_t> repeats = repeats_of_earlier(slice.contours);
    for (auto c = repeats.rbegin(); c != repeats.rend(); ++c) {
      Repeats& known = of_structure[slice.contours[*c].structure];
      if (known.count++ == 0) known.first_z = slice.z;
      slice.contours.erase(slice.contours.begin() + static_cast<std::ptrdiff_t>(*c));
    }
  }

  void make_remarks() {
    for (const Roi& roi : rois_) {
      if (!is_wanted(roi.name)) continue;
      for (const auto& [type, count] : roi.left_out) {
        result_.remarks.push_back(fmt::format("{}: {} of type {} left out", roi.name, count, type));
      }
      if (roi.taken > 0) remark_skipped_planes(roi.name);
    }
  }

  /// A structure that is not on every plane between its ends comes apart there.
  void remark_skipped_planes(const std::string& name) {
    std::vector<std::size_t> on;
    const std::vector<Slice>& slices = result_.stack.slices;
    for (std::size_t s = 0; s < slices.size(); ++s) {
      const auto& contours = slices[s].contours;
      if (std::any_of(contours.begin(), contours.end(), [&](const Contour& c) { return c.structure == name; }))
        on.push_back(s);
    }
    if (on.size() < 2) return;
    const std::size_t skipped = on.back() - on.front() + 1 - on.size();
    if (skipped == 0) return;
    const auto gap = std::adjacent_find(on.begin(), on.end(), [](std::size_t a, std::size_t b) { return b > a + 1; });
    result_.remarks.push_back(fmt::format(
        "{}: nothing on {} planes between its first and last, the first at {:.6g}; the model has a gap there. If other "
        "regions brought those planes in, choose this one alone with --structure",
        name, skipped, slices[*gap + 1].z));
  }

  DicomSet set_;
  const std::vector<std::string>& wanted_;
  Place whole_;
  std::map<std::string, std::size_t> by_number_;
  std::vector<Roi> rois_;
  std::vector<Outline> outlines_;
  std::size_t points_ = 0;
  bool guess_told_ = false;
  std::shared_ptr<DicomOrigin> origin_ = std::make_shared<DicomOrigin>();
  std::set<std::pair<std::string, std::uint32_t>> known_instances_;
  FileContours result_;
};

}  // namespace

namespace {

/// Is there an element of this tag, explicit (with the given representation) or implicit, whose value is `value`?
/// Looked for as bytes, since a damaged file may not be walked through; a longer UID is another value.
bool states(std::string_view head, std::string_view tag, std::string_view representation, std::string_view value) {
  constexpr std::size_t header = 8;
  for (std::size_t at = head.find(tag); at != head.npos; at = head.find(tag, at + 1)) {
    const std::string_view element = head.substr(at);
    if (element.size() < header + value.size() || element.substr(header, value.size()) != value) continue;
    const bool explicit_vr = element.substr(4, 2) == representation, implicit_vr = element[6] == 0 && element[7] == 0;
    const char next = element.size() > header + value.size() ? element[header + value.size()] : '\0';
    if ((explicit_vr || implicit_vr) && next != '.' && !(next >= '0' && next <= '9')) return true;
  }
  return false;
}

}  // namespace

bool looks_like_rtstruct(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::size_t looked_at = 4096;  // what a file is stands in the first elements
  const bool marked = bytes.size() > preamble && bytes.substr(preamble).starts_with("DICM");
  if (!marked && !bytes.starts_with("DICM") && !begins_as_data_set(bytes)) return false;
  const std::string_view head = bytes.substr(0, looked_at);
  // Each of three may be damaged. Other objects name the class as well, but as that of what they refer to.
  return states(head, "\x02\0\x02\0"sv, "UI", structure_set_class) ||
         states(head, "\x08\0\x16\0"sv, "UI", structure_set_class) || states(head, "\x08\0\x60\0"sv, "CS", "RTSTRUCT");
}

FileContours parse_rtstruct(std::string_view bytes, const std::string& file,
                            const std::vector<std::string>& structures) {
  if (bytes.size() > limits::structure_set_bytes) {
    Place place;
    place.file = file;
    refuse("file-too-large", place, fmt::format("the file has more than {} MiB", limits::structure_set_bytes >> 20),
           "Export fewer regions");
  }
  return StructureSetReader(bytes, file, structures).read();
}

}  // namespace odontoscope
