#include "recon/volume/dicom_directory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "recon/core/limits.h"
#include "recon/core/lower_case.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_folder.h"
#include "recon/volume/limits.h"
#include "recon/volume/text_header.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view directory_class = "1.2.840.10008.1.3.10", directory_name = "dicomdir";

/// A file as a record names it.
struct NamedFile {
  std::string id;  // parts with backslashes between
  std::string series;
};

std::uint64_t place_in(const DicomDataSet& record, std::uint32_t tag) {
  const double place = record.number(tag).value_or(0);
  return place > 0 ? static_cast<std::uint64_t>(place) : 0;
}

bool in_use(const DicomDataSet& record) { return record.number(dicom::record_in_use).value_or(1) != 0; }

std::string series_below(const DicomDataSet& record, const std::string& otherwise) {
  return record.text(dicom::record_type) == "SERIES" ? record.text(dicom::series_uid) : otherwise;
}

void take_file(const DicomDataSet& record, const std::string& series, std::vector<NamedFile>& files) {
  if (std::string id = record.text(dicom::file_id); !id.empty()) files.push_back({std::move(id), series});
}

/// From the first record on. Nothing if one names a place where none is, or one comes twice.
std::optional<std::vector<NamedFile>> followed(const std::vector<DicomDataSet>& records, std::uint64_t first) {
  std::unordered_map<std::uint64_t, std::size_t> numbers;
  for (std::size_t n = 0; n < records.size(); ++n) numbers.emplace(records[n].at, n);
  struct Open {
    std::uint64_t place;
    std::size_t series;  // the record of it; records.size(): none
  };
  std::vector<NamedFile> files;
  std::vector<bool> seen(records.size(), false);
  for (std::vector<Open> open{{first, records.size()}}; !open.empty();) {
    const Open next = open.back();
    open.pop_back();
    if (next.place == 0) continue;
    const auto found = numbers.find(next.place);
    if (found == numbers.end() || seen[found->second]) return std::nullopt;
    seen[found->second] = true;
    const DicomDataSet& record = records[found->second];
    open.push_back({place_in(record, dicom::next_record), next.series});
    if (!in_use(record)) continue;
    take_file(record, next.series < records.size() ? records[next.series].text(dicom::series_uid) : std::string(),
              files);
    const bool of_series = record.text(dicom::record_type) == "SERIES";
    open.push_back({place_in(record, dicom::lower_record), of_series ? found->second : next.series});
  }
  return files;
}

/// All in the order of the file: those of a series stand behind its record.
std::vector<NamedFile> in_order(const std::vector<DicomDataSet>& records) {
  std::vector<NamedFile> files;
  std::string series;
  for (const DicomDataSet& record : records) {
    if (!in_use(record)) continue;
    series = series_below(record, series);
    take_file(record, series, files);
  }
  return files;
}

/// "A\\B" to A and B; nothing for what is no name.
std::optional<std::vector<std::string>> parts_of(const std::string& id) {
  if (id.size() > limits::file_id_length) return std::nullopt;
  std::vector<std::string> parts;
  std::string_view rest = id;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\\'), rest.size());
    std::string part(trimmed(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (std::any_of(part.begin(), part.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }))
      return std::nullopt;
    if (!part.empty()) parts.push_back(std::move(part));
  }
  if (parts.empty() || parts.size() > limits::file_id_parts) return std::nullopt;
  return parts;
}

/// As other systems show the same name.
std::string plain_name(std::string name) {
  if (name.ends_with(";1")) name.resize(name.size() - 2);
  while (name.size() > 1 && name.ends_with('.')) name.pop_back();
  return lower_case(std::move(name));
}

[[noreturn]] void refuse_too_many(const std::string& directory) {
  throw InputError("too-many-files", in_file(directory),
                   fmt::format("there are more than {} files in it", limits::dicom_files),
                   "put the series alone into a folder");
}

/// Finds files of a DICOMDIR by their names.
class Disc {
 public:
  Disc(const std::string& directory, bool allow_outside)
      : directory_(directory), folder_(fs::path(directory).parent_path()), allow_outside_(allow_outside) {
    if (folder_.empty()) folder_ = ".";
  }

  /// Nothing if there is no such plain file. Throws InputError outside-folder, too-many-files.
  std::optional<std::string> find(const std::vector<std::string>& parts) {
    fs::path named = folder_;
    for (const std::string& part : parts) named /= part;
    check(named);
    fs::path at = folder_;
    for (const std::string& part : parts) {
      std::error_code error;
      if (fs::exists(fs::symlink_status(at / part, error))) {
        at /= part;
        continue;
      }
      const std::string* name = name_in(at, part);
      if (name == nullptr) return std::nullopt;
      at /= *name;
    }
    check(at);
    std::error_code error;
    if (!fs::is_regular_file(at, error)) return std::nullopt;
    return at.string();
  }

 private:
  /// Most lie in few folders, which are looked at once.
  void check(const fs::path& file) {
    if (allow_outside_) return;
    std::error_code error;
    const bool is_link = fs::is_symlink(fs::symlink_status(file, error));
    const bool known = inside_.contains(file.parent_path());
    if (known && !is_link && file.filename() != "..") return;
    if (!lies_inside(directory_, file.string())) {
      throw InputError("outside-folder", in_file(directory_),
                       fmt::format("it names {}, which lies outside its own folder", file.string()),
                       "put its files beside it, or give --allow-outside if you trust it");
    }
    if (lies_inside(directory_, file.parent_path().string())) inside_.insert(file.parent_path());
  }

  const std::string* name_in(const fs::path& folder, const std::string& name) {
    const auto [listed, is_new] = names_.try_emplace(folder);
    if (is_new) {
      std::error_code error;
      fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
      for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
        if (++seen_ > limits::dicom_files) refuse_too_many(directory_);
        const std::string own = entry->path().filename().string();
        std::string& kept = listed->second[plain_name(own)];
        if (kept.empty() || own < kept) kept = own;  // of two, the same on every disk
      }
    }
    const auto found = listed->second.find(plain_name(name));
    return found == listed->second.end() ? nullptr : &found->second;
  }

  std::string directory_;
  fs::path folder_;
  bool allow_outside_;
  std::set<fs::path> inside_;
  std::map<fs::path, std::map<std::string, std::string>> names_;
  std::size_t seen_ = 0;
};

}  // namespace

bool is_dicom_directory(const DicomFile& file) {
  return file.storage_class == directory_class || file.data.text(dicom::class_uid) == directory_class ||
         lower_case(fs::path(file.path).filename().string()) == directory_name;
}

std::string dicom_directory_in(const std::string& folder) {
  std::error_code error;
  const fs::path usual = fs::path(folder) / "DICOMDIR";
  if (fs::is_regular_file(usual, error)) return usual.string();
  fs::directory_iterator entry(folder, error);
  for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (plain_name(entry->path().filename().string()) == directory_name && entry->is_regular_file(ignored))
      return entry->path().string();
  }
  return {};
}

DicomDirectory dicom_directory(const DicomFile& file, bool allow_outside, const Progress& progress) {
  DicomDirectory directory;
  const DicomElement* records = file.data.find(dicom::records);
  if (records == nullptr) return directory;
  std::optional<std::vector<NamedFile>> named = followed(records->items, place_in(file.data, dicom::first_record));
  if (!named || (named->empty() && place_in(file.data, dicom::first_record) == 0)) {
    named = in_order(records->items);
    directory.remarks.push_back(
        "the records of the DICOMDIR do not lead to each other as they should: all of them are taken");
  }
  Disc disc(file.path, allow_outside);
  std::set<std::string> ids;
  for (const NamedFile& one : *named) {
    progress.check();
    if (!ids.insert(one.id).second) continue;
    if (ids.size() > limits::dicom_files) refuse_too_many(file.path);
    const auto parts = parts_of(one.id);
    const auto found = parts ? disc.find(*parts) : std::nullopt;
    if (found && looks_like_dicom(*found))
      directory.files.push_back(*found);
    else
      directory.missing.push_back({one.series, one.id});
  }
  std::sort(directory.files.begin(), directory.files.end());
  directory.files.erase(std::unique(directory.files.begin(), directory.files.end()), directory.files.end());
  return directory;
}

std::string names_of(const std::vector<DicomDirectory::Missing>& missing) {
  std::vector<std::string> names;
  for (std::size_t n = 0; n < std::min(missing.size(), limits::names_told); ++n) {
    names.push_back(tamed(missing[n].name));
    std::replace(names.back().begin(), names.back().end(), '\\', '/');
  }
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  return missing.size() <= limits::names_told ? all
                                              : fmt::format("{} and {} more", all, missing.size() - limits::names_told);
}

}  // namespace odontoscope
