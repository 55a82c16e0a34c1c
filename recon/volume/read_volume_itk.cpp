#include "recon/volume/read_volume_itk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "recon/core/error.h"
#include "recon/core/limits.h"

namespace odontoscope {
namespace {

using Component = itk::IOComponentEnum;

void check_kind(const OpenedImage& opened) {
  const itk::ImageIOBase& io = *opened.io;
  Place place;
  place.file = opened.image.source;
  if (io.GetNumberOfComponents() != 1) {
    throw InputError("not-scalar", place,
                     fmt::format("each voxel has {} numbers (a colour or a vector)", io.GetNumberOfComponents()),
                     "give a volume with one number a voxel");
  }
  for (unsigned axis = 3; axis < io.GetNumberOfDimensions(); ++axis) {
    if (io.GetDimensions(axis) != 1) {
      throw InputError("not-3d", place, fmt::format("the image has {} dimensions", io.GetNumberOfDimensions()),
                       "give one volume of a time series");
    }
  }
  if (io.GetComponentType() == Component::UNKNOWNCOMPONENTTYPE || io.GetPixelType() == itk::IOPixelEnum::COMPLEX) {
    throw InputError("pixel-type", place, "the voxels are no integer or floating-point numbers",
                     "convert them to such");
  }
}

template <class T>
void convert(const std::vector<std::byte>& raw, float* to) {
  const std::size_t count = raw.size() / sizeof(T);
  for (std::size_t n = 0; n < count; ++n) {
    T value;
    std::memcpy(&value, raw.data() + n * sizeof(T), sizeof(T));
    to[n] = static_cast<float>(value);
  }
}

void convert_as(Component type, const std::vector<std::byte>& raw, float* to) {
  switch (type) {
    case Component::UCHAR:
      return convert<unsigned char>(raw, to);
    case Component::CHAR:
      return convert<signed char>(raw, to);
    case Component::USHORT:
      return convert<unsigned short>(raw, to);
    case Component::SHORT:
      return convert<short>(raw, to);
    case Component::UINT:
      return convert<unsigned int>(raw, to);
    case Component::INT:
      return convert<int>(raw, to);
    case Component::ULONG:
      return convert<unsigned long>(raw, to);
    case Component::LONG:
      return convert<long>(raw, to);
    case Component::ULONGLONG:
      return convert<unsigned long long>(raw, to);
    case Component::LONGLONG:
      return convert<long long>(raw, to);
    case Component::FLOAT:
      return convert<float>(raw, to);
    case Component::DOUBLE:
      return convert<double>(raw, to);
    default:
      throw InternalError("an unknown pixel type got past the header");
  }
}

}  // namespace

void throw_unreadable(const std::string& file, const std::string& part, const std::string& what) {
  // The last line of several tells the root of it; "Class(address): " in front changes from run to run.
  constexpr std::size_t enough = 200;
  std::string words = what.substr(0, what.find_last_not_of(" \n") + 1);
  words.erase(0, words.rfind('\n') + 1);
  if (const std::size_t address = words.find("(0x"); address != std::string::npos) {
    words.erase(0, std::min(words.find("): ", address), words.size() - 3) + 3);
  }
  words.resize(std::min(words.size(), enough));
  std::replace_if(
      words.begin(), words.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, ' ');
  Place place;
  place.file = file;
  throw InputError("unreadable-volume", place, fmt::format("its {} cannot be read: {}", part, words),
                   "get a whole copy of the file, or convert it with the program that wrote it");
}

OpenedImage open_image(itk::ImageIOBase::Pointer io, const std::string& file) {
  OpenedImage opened;
  opened.io = io;
  FileImage& image = opened.image;
  image.source = file;
  try {
    io->SetFileName(file);
    io->ReadImageInformation();
    check_kind(opened);
    const unsigned dimensions = std::min(io->GetNumberOfDimensions(), 3u);
    for (unsigned n = 0; n < dimensions; ++n) {
      image.size[n] = io->GetDimensions(n);
      image.spacing[n] = io->GetSpacing(n);
      image.origin[n] = io->GetOrigin(n);
      const std::vector<double> direction = io->GetDirection(n);
      for (std::size_t axis = 0; axis < 3; ++axis)
        image.direction[n][axis] = axis < direction.size() ? direction[axis] : 0;
    }
  } catch (const itk::ExceptionObject& error) {
    throw_unreadable(file, "header", error.GetDescription());
  }
  return opened;
}

std::size_t bytes_of_pixels(const OpenedImage& opened) {
  const auto& size = opened.image.size;
  return size[0] * size[1] * size[2] * opened.io->GetComponentSize();
}

void read_pixels(const OpenedImage& opened, float* to) {
  itk::ImageIOBase& io = *opened.io;
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned n = 0; n < io.GetNumberOfDimensions(); ++n) region.SetSize(n, io.GetDimensions(n));
  std::vector<std::byte> raw(bytes_of_pixels(opened));
  try {
    io.SetIORegion(region);
    io.Read(raw.data());
  } catch (const itk::ExceptionObject& error) {
    throw_unreadable(opened.image.source, "pixels", error.GetDescription());
  }
  convert_as(io.GetComponentType(), raw, to);
}

}  // namespace odontoscope
