#include "tests/volume/volume_files.h"

#include <zlib.h>

#include <cstring>
#include <numeric>
#include <stdexcept>

namespace odontoscope::test {
namespace {

std::string packed(const std::string& bytes, int window) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib");
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("zlib");
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

template <class T>
void put(std::string& bytes, std::size_t offset, const T& value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

}  // namespace

std::vector<std::uint8_t> telling_voxels() {
  std::vector<std::uint8_t> voxels(telling_size[0] * telling_size[1] * telling_size[2]);
  std::iota(voxels.begin(), voxels.end(), std::uint8_t{1});
  return voxels;
}

std::string zlib_packed(const std::string& bytes) { return packed(bytes, 15); }
std::string gzip_packed(const std::string& bytes) { return packed(bytes, 15 + 16); }

std::string Nrrd::bytes() const {
  return "NRRD0004\n# a comment: with a colon\ntype: " + type + "\ndimension: " + dimension + "\nsizes: " + sizes +
         "\n" + more + "endian: little\nencoding: " + encoding + "\n\n" + pixels;
}

std::string MetaImage::bytes() const {
  return "ObjectType = Image\nNDims = " + dimensions + "\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + more +
         "DimSize = " + size + "\nElementType = " + type + "\nElementDataFile = " + data_file + "\n" + pixels;
}

std::string Nifti::bytes() const {
  std::string header(352, '\0');
  put(header, 0, std::int32_t{348});
  put(header, 40, dim);
  put(header, 70, datatype);
  put(header, 72, bits);
  put(header, 76, pixdim);
  put(header, 108, vox_offset);
  put(header, 112, slope);
  put(header, 116, intercept);
  put(header, 252, qform);
  put(header, 254, sform);
  put(header, 280, srow);
  std::memcpy(header.data() + 344, magic.data(), magic.size());
  return header + pixels;
}

}  // namespace odontoscope::test
