#pragma once
// Bytes of small volume files, whole or lied about: what a writer of NRRD, MetaImage or NIfTI would make, with any
// header line changed.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace odontoscope::test {

/// Little-endian bytes of numbers.
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// 5 x 4 x 3 values that tell their own voxel: 1 + i + 5 j + 20 k; 60 at most.
std::vector<std::uint8_t> telling_voxels();
inline constexpr std::array<std::size_t, 3> telling_size{5, 4, 3};

std::string zlib_packed(const std::string& bytes);
std::string gzip_packed(const std::string& bytes);

struct Nrrd {
  std::string type = "uint8", sizes = "5 4 3", encoding = "raw", dimension = "3";
  std::string more = {};  // lines, each with its end
  std::string pixels = bytes_of(telling_voxels());
  std::string bytes() const;
};

struct MetaImage {
  std::string type = "MET_UCHAR", dimensions = "3", size = "5 4 3", data_file = "LOCAL";
  std::string more = {};
  std::string pixels = bytes_of(telling_voxels());
  std::string bytes() const;
};

struct Nifti {
  std::array<std::int16_t, 8> dim{3, 5, 4, 3, 1, 1, 1, 1};
  std::int16_t datatype = 2, bits = 8, qform = 0, sform = 0;
  std::array<float, 4> pixdim{1, 1, 1, 1};  // qfac and the spacing
  float vox_offset = 352, slope = 0, intercept = 0;
  std::array<float, 12> srow{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::string magic = "n+1";
  std::string pixels = bytes_of(telling_voxels());
  std::string bytes() const;
};

}  // namespace odontoscope::test
