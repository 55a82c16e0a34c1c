#include "tests/volume/dicomdir.h"

#include <algorithm>

namespace odontoscope::test {
namespace {

DicomObject& place(DicomObject& object, std::uint16_t element, std::uint32_t at) {
  return object.shorts(4, element, {static_cast<std::uint16_t>(at & 0xffff), static_cast<std::uint16_t>(at >> 16)},
                       "UL");
}

/// As records name each other: `places` of those from 1 on.
std::string written(const DicomDir& directory, const std::vector<std::uint32_t>& places) {
  std::vector<DicomObject> items;
  for (const DirectoryRecord& record : directory.records) {
    DicomObject item(directory.coding);
    place(item, 0x1400, record.astray != 0 ? record.astray : places[record.next]);
    item.shorts(4, 0x1410, {static_cast<std::uint16_t>(record.in_use ? 0xffff : 0)});
    place(item, 0x1420, places[record.lower]).text(4, 0x1430, "CS", record.type);
    if (!record.file.empty()) item.text(4, 0x1500, "CS", record.file);
    if (!record.series.empty()) item.text(8, 0x60, "CS", "CT").text(0x20, 0xe, "UI", record.series);
    items.push_back(item);
  }
  DicomObject whole(directory.coding);
  whole.text(4, 0x1130, "CS", "DISC");
  place(whole, 0x1200, places[directory.first]);
  place(whole, 0x1202, places[directory.first]).shorts(4, 0x1212, {0});
  whole.sequence(4, 0x1220, items, directory.open_items);
  return whole.file({}, "1.2.840.10008.1.3.10");
}

}  // namespace

std::vector<DirectoryRecord> records_of(const std::vector<DirectorySeries>& series) {
  std::vector<DirectoryRecord> records{{.type = "PATIENT", .lower = 2}, {.type = "STUDY", .lower = 3}};
  for (std::size_t s = 0; s < series.size(); ++s) {
    const std::size_t own = records.size() + 1, files = series[s].files.size();
    records.push_back({.type = "SERIES", .series = series[s].uid, .lower = files == 0 ? 0 : own + 1});
    if (s + 1 < series.size()) records.back().next = own + files + 1;
    for (std::size_t n = 0; n < files; ++n) {
      records.push_back({.type = "IMAGE", .file = series[s].files[n], .next = n + 1 < files ? own + n + 2 : 0});
    }
  }
  return records;
}

/// What a record takes does not hang on where it points, so that all places are known from one that points nowhere.
std::string DicomDir::bytes() const {
  std::vector<std::uint32_t> places(std::max(records.size(), first) + 1, 0);
  const std::string pointless = written(*this, places);
  const std::string item("\xfe\xff\x00\xe0", 4);
  std::size_t from = pointless.find(std::string("\x04\x00\x20\x12", 4));
  for (std::size_t n = 1; n <= records.size(); ++n) {
    from = pointless.find(item, from);
    places[n] = static_cast<std::uint32_t>(from);
    from += item.size();
  }
  return written(*this, places);
}

}  // namespace odontoscope::test
