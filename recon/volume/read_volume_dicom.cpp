#include "recon/volume/read_volume_dicom.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "recon/core/error.h"
#include "recon/volume/byte_source.h"
#include "recon/volume/dicom_folder.h"
#include "recon/volume/dicom_pixels.h"
#include "recon/volume/dicom_segmentation.h"
#include "recon/volume/dicom_stack.h"

namespace odontoscope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view directory_class = "1.2.840.10008.1.3.10";

struct Found {
  std::vector<DicomFile> files;
  std::vector<std::string> remarks;
};

/// A DICOMDIR lists what lies in its folder and below.
bool is_directory_file(const DicomFile& file, const std::string& path) {
  return file.data.text(dicom::class_uid) == directory_class || fs::path(path).filename() == "DICOMDIR";
}

std::string folder_of(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

void tell_unknown(const DicomFolder& folder, Found& found) {
  for (const DicomFile& file : folder.unknown) found.remarks.push_back(fmt::format("{} is damaged, does not tell its series, and was passed over", file.path));
}

Found in_folder(const std::string& path, const std::string& folder_path, const ReadVolumeOptions& options, Depth depth, const Progress& progress) {
  DicomFolder folder = dicom_folder(folder_path, depth, progress);
  const bool searched_below = depth == Depth::folder_only && folder.series.empty() && folder.unknown.empty();
  if (searched_below) folder = dicom_folder(folder_path, Depth::below_too, progress);
  if (folder.series.empty()) {
    if (!folder.unknown.empty()) throw *folder.unknown.front().trouble;
    throw InputError("no-dicom-images", in_file(path), "there is no DICOM image in it, nor in folders below it", "give the folder of a series");
  }
  Found found;
  std::size_t number = 0;
  if (!options.series.empty()) {
    number = chosen_series(folder, options.series, path);
    tell_unknown(folder, found);
  } else if (folder.series.size() > 1) {
    throw InputError("several-series", in_file(path), fmt::format("there are {} series of images in it:\n{}", folder.series.size(), list_of(folder)),
                     "Choose one by its number (--series N), or give a file of it");
  } else if (!folder.unknown.empty()) {
    const InputError& trouble = *folder.unknown.front().trouble;
    std::string words = trouble.what();
    words.resize(std::min(words.rfind(". ["), words.size()));
    throw InputError(trouble.cause(), {}, words, "If it is none of the wanted series, give a file of that one, or --series 1");
  }
  found.files = std::move(folder.series[number].files);
  if (searched_below) found.remarks.push_back(fmt::format("its images lie below it, in {}", folder_of(found.files.front().path)));
  return found;
}

/// The other files of the series that `own` is of.
Found beside(const std::string& path, DicomFile own, const ReadVolumeOptions& options, const Progress& progress) {
  if (own.trouble) throw *own.trouble;
  if (is_directory_file(own, path)) return in_folder(path, folder_of(path), options, Depth::below_too, progress);
  if (!is_dicom_image(own)) throw InputError("no-dicom-images", in_file(path), "the file is DICOM, but no image", "give a file of an image series");
  Found found;
  const bool whole = is_dicom_segmentation(own) || (own.data.number(dicom::frames).value_or(1) > 1 && own.data.text(dicom::concatenation_uid).empty());
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
  if (fs::is_directory(path)) return in_folder(path, path, options, options.series.empty() ? Depth::folder_only : Depth::below_too, progress);
  return beside(path, read_dicom_file(path), options, progress);
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
    DicomInstance instance{image.file.data.text(dicom::class_uid), image.instance, 0, image.frames[plane.frame].position};
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
      origin->instances.push_back({item.text(dicom::referenced_class), item.text(dicom::referenced_instance), 0, std::nullopt});
    }
  }
  return origin;
}

Volume segmentation_volume(const DicomImage& image, std::vector<std::string> remarks, const std::string& path, const ReadVolumeOptions& options, const Progress& progress) {
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
  if (images.size() == 1 && is_dicom_segmentation(images.front().file)) return segmentation_volume(images.front(), std::move(found.remarks), path, options, progress);
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
