#include "recon/volume/read_volume_dicom.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "recon/core/error.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_directory.h"
#include "recon/volume/dicom_folder.h"
#include "recon/volume/dicom_pixels.h"
#include "recon/volume/dicom_segmentation.h"
#include "recon/volume/dicom_stack.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

struct Found {
  std::vector<DicomFile> files;
  std::vector<std::string> remarks;
};

std::string folder_of(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

/// A message without its cause, to be part of another.
std::string message_of(const InputError& error) {
  std::string words = error.what();
  words.resize(std::min(words.rfind(". ["), words.size()));
  return words;
}

void tell_unknown(const DicomFolder& folder, Found& found) {
  for (const DicomFile& file : folder.unknown)
    found.remarks.push_back(fmt::format("{} is damaged, does not tell its series, and was passed over", file.path));
}

/// The one that is asked for, or the only one.
Found wanted_of(DicomFolder folder, const std::string& path, const ReadVolumeOptions& options) {
  if (folder.series.empty()) {
    if (!folder.unknown.empty()) throw *folder.unknown.front().trouble;
    throw InputError("no-dicom-images", in_file(path), "there is no DICOM image in it, nor in folders below it",
                     "give the folder of a series");
  }
  Found found;
  std::size_t number = 0;
  if (!options.series.empty()) {
    number = chosen_series(folder, options.series, path);
    tell_unknown(folder, found);
  } else if (folder.series.size() > 1) {
    std::vector<SeriesOffer> offers = offers_of(folder);
    const std::string words = fmt::format("there are {} series of images in it:\n{}", offers.size(), list_of(offers));
    throw SeveralSeries(in_file(path), words, std::move(offers));
  } else if (!folder.unknown.empty()) {
    const InputError& trouble = *folder.unknown.front().trouble;
    throw InputError(trouble.cause(), {}, message_of(trouble),
                     "If it is none of the wanted series, give a file of that one, or --series 1");
  }
  found.files = std::move(folder.series[number].files);
  return found;
}

/// What a DICOMDIR names and lacks must not be of the series that is read: a solid would end where the files do.
void refuse_missing(const DicomDirectory& directory, const std::string& path, Found& found) {
  const std::string uid = found.files.front().data.text(dicom::series_uid);
  std::vector<DicomDirectory::Missing> own, others;
  for (const DicomDirectory::Missing& one : directory.missing)
    (!one.series.empty() && one.series == uid ? own : others).push_back(one);
  if (!own.empty()) {
    throw InputError("missing-files", in_file(path),
                     fmt::format("of the series it names {} {} that cannot be found: {}", own.size(),
                                 own.size() == 1 ? "file" : "files", names_of(own)),
                     "copy them too, or give a file of the series to read those that are there");
  }
  if (!others.empty())
    found.remarks.push_back(fmt::format("the DICOMDIR names {} other {} that cannot be found: {}", others.size(),
                                        others.size() == 1 ? "file" : "files", names_of(others)));
}

/// By a DICOMDIR; nothing, and a remark, where none of what it names is there.
std::optional<Found> named_by(const DicomDirectory& directory, const std::string& path,
                              const ReadVolumeOptions& options, std::vector<std::string>& remarks,
                              const Progress& progress) {
  DicomFolder folder = dicom_series_of(directory.files, progress);
  if (folder.series.empty() && folder.unknown.empty()) {
    remarks.push_back(directory.missing.empty() ? "its DICOMDIR names no images: its folder was searched for them"
                                                : fmt::format("of the images that its DICOMDIR names none is there "
                                                              "(such as {}): its folder was searched for others",
                                                              names_of(directory.missing)));
    return std::nullopt;
  }
  Found found = wanted_of(std::move(folder), path, options);
  refuse_missing(directory, path, found);
  found.remarks.insert(found.remarks.begin(), directory.remarks.begin(), directory.remarks.end());
  return found;
}

/// A series called by its name may lie below one that has others; numbers are those of the list that was told.
bool asks_below(const DicomFolder& folder, const std::string& series) {
  const bool is_number = std::all_of(series.begin(), series.end(), [](char c) { return c >= '0' && c <= '9'; });
  return !series.empty() && !is_number && series_named(folder, series).empty();
}

/// All that lies in a folder, whatever a DICOMDIR says; below it too if it has no images itself.
Found searched(const std::string& path, const std::string& folder_path, const ReadVolumeOptions& options,
               const Progress& progress) {
  DicomFolder folder = dicom_folder(folder_path, Depth::folder_only, progress);
  const bool searched_below = folder.series.empty() && folder.unknown.empty();
  if (searched_below || asks_below(folder, options.series))
    folder = dicom_folder(folder_path, Depth::below_too, progress);
  Found found = wanted_of(std::move(folder), path, options);
  if (searched_below)
    found.remarks.push_back(fmt::format("its images lie below it, in {}", folder_of(found.files.front().path)));
  return found;
}

Found in_directory(const std::string& path, const DicomFile& file, const ReadVolumeOptions& options,
                   const Progress& progress) {
  std::vector<std::string> remarks;
  if (auto found = named_by(dicom_directory(file, options.allow_outside, progress), path, options, remarks, progress))
    return std::move(*found);
  Found found = searched(path, folder_of(path), options, progress);
  found.remarks.insert(found.remarks.begin(), remarks.begin(), remarks.end());
  return found;
}

/// The first of the files in the folder itself that the DICOMDIR does not name; empty if it names all. It is then
/// another folder's, or an old one.
std::string unnamed_in(const std::string& folder, const std::string& directory_file, const DicomDirectory& directory,
                       const Progress& progress) {
  for (const std::string& file : dicom_candidates(folder, Depth::folder_only, progress)) {
    if (file != directory_file && !std::binary_search(directory.files.begin(), directory.files.end(), file))
      return file;
  }
  return {};
}

/// By its DICOMDIR if there is one and it is of this folder; else by what lies there.
Found in_folder(const std::string& path, const ReadVolumeOptions& options, const Progress& progress) {
  std::vector<std::string> remarks;
  if (const std::string file = dicom_directory_in(path); !file.empty()) {
    const DicomFile read = read_dicom_file(file);
    if (read.trouble) {
      remarks.push_back(fmt::format("its DICOMDIR is damaged and was passed over ({})", read.trouble->wrong()));
    } else {
      const DicomDirectory directory = dicom_directory(read, options.allow_outside, progress);
      const std::string unnamed = unnamed_in(path, file, directory, progress);
      if (!unnamed.empty())
        remarks.push_back(
            fmt::format("its DICOMDIR does not name {}, which lies beside it, and was passed over", unnamed));
      else if (auto found = named_by(directory, path, options, remarks, progress))
        return std::move(*found);
    }
  }
  Found found = searched(path, path, options, progress);
  found.remarks.insert(found.remarks.begin(), remarks.begin(), remarks.end());
  return found;
}

/// The other files of the series that `own` is of.
Found beside(const std::string& path, DicomFile own, const Progress& progress) {
  if (!is_dicom_image(own))
    throw InputError("no-dicom-images", in_file(path), "the file is DICOM, but no image",
                     "give a file of an image series");
  Found found;
  const bool whole = is_dicom_segmentation(own) || (own.data.number(dicom::frames).value_or(1) > 1 &&
                                                    own.data.text(dicom::concatenation_uid).empty());
  const std::string uid = own.data.text(dicom::series_uid), together = own.data.text(dicom::concatenation_uid);
  if (whole || uid.empty()) {
    found.files.push_back(std::move(own));
    return found;
  }
  DicomFolder folder = dicom_folder(folder_of(path), Depth::folder_only, progress);
  for (DicomSeries& series : folder.series) {
    const DicomFile& first = series.files.front();
    if (series.uid != uid || first.data.text(dicom::concatenation_uid) != together) continue;
    if ((first.data.number(dicom::frames).value_or(1) > 1) != !together.empty()) continue;
    found.files = std::move(series.files);
    break;
  }
  tell_unknown(folder, found);
  return found;
}

Found files_of(const std::string& path, const ReadVolumeOptions& options, const Progress& progress) {
  if (fs::is_directory(path)) return in_folder(path, options, progress);
  DicomFile file = read_dicom_file(path);
  const bool is_directory = is_dicom_directory(file);
  if (file.trouble && is_directory) {
    throw InputError(file.trouble->cause(), file.trouble->place(), file.trouble->wrong(),
                     "Get a whole copy of it, or give its folder, which is then searched without it");
  }
  if (file.trouble) throw *file.trouble;
  return is_directory ? in_directory(path, file, options, progress) : beside(path, std::move(file), progress);
}

/// Whose images they are.
std::shared_ptr<DicomOrigin> identity_of(const DicomImage& first) {
  auto origin = std::make_shared<DicomOrigin>();
  const DicomDataSet& data = first.file.data;
  for (const std::uint32_t tag : dicom::identity) {
    if (std::string text = data.text(tag); !text.empty()) origin->identity.emplace(tag, std::move(text));
  }
  origin->character_set = data.text(dicom::character_set);
  origin->frame_of_reference = data.text(dicom::frame_of_reference);
  origin->position_indicator = data.text(dicom::position_indicator);
  origin->study = data.text(dicom::study_uid);
  return origin;
}

/// And which.
std::shared_ptr<const DicomOrigin> origin_of(const DicomStack& stack) {
  const DicomImage& first = *stack.planes.front().image;
  std::shared_ptr<DicomOrigin> origin = identity_of(first);
  origin->series = first.series;
  const Vector3& normal = stack.image.direction[2];
  for (const DicomPlane& plane : stack.planes) {
    const DicomImage& image = *plane.image;
    DicomInstance instance{image.file.data.text(dicom::class_uid), image.instance, 0,
                           image.frames[plane.frame].position};
    if (image.frames.size() > 1) instance.frame = static_cast<std::uint32_t>(plane.frame + 1);
    if (instance.position) origin->normal = normal;
    origin->instances.push_back(std::move(instance));
  }
  return origin;
}

/// The images that a segmentation was made on, as far as it names them; where each of them lies it does not say.
std::shared_ptr<const DicomOrigin> referenced_by(const DicomImage& image) {
  std::shared_ptr<DicomOrigin> origin = identity_of(image);
  const DicomDataSet* series = image.file.data.item(dicom::referenced_series);
  if (series == nullptr) return origin;
  origin->series = series->text(dicom::series_uid);
  if (const DicomElement* instances = series->find(dicom::referenced_instances)) {
    for (const DicomDataSet& item : instances->items) {
      origin->instances.push_back(
          {item.text(dicom::referenced_class), item.text(dicom::referenced_instance), 0, std::nullopt});
    }
  }
  return origin;
}

Volume segmentation_volume(const DicomImage& image, std::vector<std::string> remarks, const std::string& path,
                           const ReadVolumeOptions& options, const Progress& progress) {
  Volume volume = dicom_segmentation(image, path, options, progress);
  volume.patient.dicom = referenced_by(image);
  remarks.insert(remarks.end(), volume.remarks.begin(), volume.remarks.end());
  volume.remarks = std::move(remarks);
  return volume;
}

}  // namespace

Volume read_dicom_volume(const std::string& path, const ReadVolumeOptions& options, const Progress& progress) {
  Found found = files_of(path, options, progress);
  std::vector<DicomImage> images;
  for (DicomFile& file : found.files) {
    if (auto image = dicom_image(std::move(file))) images.push_back(std::move(*image));
  }
  if (images.size() == 1 && is_dicom_segmentation(images.front().file))
    return segmentation_volume(images.front(), std::move(found.remarks), path, options, progress);
  std::vector<const DicomImage*> all;
  for (const DicomImage& image : images) all.push_back(&image);
  DicomStack stack = stack_planes(all, path, options);
  FileImage& image = stack.image;
  oriented_grid(image);  // throws what is wrong with it before memory is asked for
  check_memory(path, image.size[0] * image.size[1] * image.size[2]);
  image.values = read_planes(stack.planes, progress);
  Volume volume = oriented(std::move(image));
  volume.patient.dicom = origin_of(stack);
  volume.remarks = std::move(found.remarks);
  volume.remarks.insert(volume.remarks.end(), stack.remarks.begin(), stack.remarks.end());
  return volume;
}

}  // namespace odontoscope
