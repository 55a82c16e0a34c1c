// What the elements of a data set say (see dicom_file.h).

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "recon/volume/dicom_file.h"
#include "recon/volume/text_header.h"

namespace odontoscope {
namespace {

double binary_number(const DicomElement& element, std::string_view raw) {
  std::array<char, 8> bytes{};
  std::copy(raw.begin(), raw.end(), bytes.begin());
  if (element.big_endian != (std::endian::native == std::endian::big))
    std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(raw.size()));
  const auto as = [&bytes](auto value) {
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  };
  const std::string_view vr(element.vr.data(), 2);
  if (vr == "FD") return as(double{});
  if (vr == "FL") return as(float{});
  if (vr == "SL") return as(std::int32_t{});
  if (vr == "SS") return as(std::int16_t{});
  return raw.size() == 4 ? as(std::uint32_t{}) : as(std::uint16_t{});
}

/// How many bytes each number of a binary element has; 0 for text.
std::size_t binary_width(const DicomElement& element) {
  const std::string_view vr(element.vr.data(), 2);
  if (vr == "FD") return 8;
  if (vr == "FL" || vr == "SL" || vr == "UL") return 4;
  if (vr == "SS" || vr == "US" || vr == "AT") return 2;
  if (element.vr[0] != 0 && vr != "UN") return 0;
  // Implied: those of the wanted elements that PS3.6 lists as US, AT or UL.
  switch (element.tag) {
    case dicom::samples:
    case dicom::rows:
    case dicom::columns:
    case dicom::bits_allocated:
    case dicom::bits_stored:
    case dicom::high_bit:
    case dicom::is_signed:
    case dicom::segment_number:
    case dicom::referenced_segment:
    case dicom::fraction_of:
    case dicom::record_in_use:
    case dicom::frame_increment:
      return 2;
    case dicom::first_record:
    case dicom::next_record:
    case dicom::lower_record:
    case dicom::temporal_index:
      return 4;
    default:
      return 0;
  }
}

}  // namespace

const DicomElement* DicomDataSet::find(std::uint32_t tag) const {
  // The last of several, as readers take it; valid files have one.
  const auto found =
      std::find_if(elements.rbegin(), elements.rend(), [tag](const DicomElement& e) { return e.tag == tag; });
  return found == elements.rend() ? nullptr : &*found;
}

const DicomDataSet* DicomDataSet::item(std::uint32_t sequence) const {
  const DicomElement* found = find(sequence);
  return found == nullptr || found->items.empty() ? nullptr : &found->items.front();
}

std::string DicomDataSet::text(std::uint32_t tag) const {
  const DicomElement* found = find(tag);
  if (found == nullptr) return {};
  std::string text = found->value;
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return std::string(trimmed(text));
}

std::vector<double> DicomDataSet::numbers(std::uint32_t tag) const {
  const DicomElement* found = find(tag);
  std::vector<double> numbers;
  if (found == nullptr) return numbers;
  if (const std::size_t width = binary_width(*found); width > 0) {
    for (std::size_t from = 0; from + width <= found->value.size(); from += width) {
      numbers.push_back(binary_number(*found, std::string_view(found->value).substr(from, width)));
      if (!std::isfinite(numbers.back())) return {};
    }
    return numbers;
  }
  std::string_view rest = found->value;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\\'), rest.size());
    std::string word(rest.substr(0, end));
    while (!word.empty() && word.back() == '\0') word.pop_back();
    double number = 0;
    if (!number_of(trimmed(word), number) || !std::isfinite(number)) return {};
    numbers.push_back(number);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return numbers;
}

std::optional<double> DicomDataSet::number(std::uint32_t tag) const {
  const std::vector<double> all = numbers(tag);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

}  // namespace odontoscope
