#include "engine/picture/png.h"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "recon/core/atomic_file.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/read_file.h"

namespace odontoscope {
namespace {

constexpr int png_compression = 4;  // of zlib's 9: a tenth larger than the best in a third of the time
constexpr std::size_t most_png_bytes = 1u << 30;
constexpr std::size_t most_chunk_bytes = 8u << 20;  // of what says nothing of pixels
constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// What libpng complained of; it leaves by longjmp, so nothing between may need a destructor.
struct Complaint {
  std::array<char, 128> words{};
  bool pixels_left = false;  // there is more than the header's size makes

  void take(const char* said) { std::strncpy(words.data(), said, words.size() - 1); }
};

[[noreturn]] void fail(png_structp png, png_const_charp words) {
  static_cast<Complaint*>(png_get_error_ptr(png))->take(words);
  png_longjmp(png, 1);
}

void warn(png_structp png, png_const_charp words) {
  const std::string_view said(words);
  if (said.find("xtra compressed data") != said.npos || said.find("oo much image data") != said.npos)
    static_cast<Complaint*>(png_get_error_ptr(png))->pixels_left = true;
}

void append(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

void take(png_structp png, png_bytep data, std::size_t size) {
  auto& left = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (size > left.size()) png_error(png, "the PNG ends before what it announces");
  std::memcpy(data, left.data(), size);
  left.remove_prefix(size);
}

/// False with a complaint. `rows` point into the picture.
bool encode(png_structp png, png_infop info, const Image& image, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_compression_level(png, png_compression);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, info);
  return true;
}

bool decode(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_info(png, info);
  png_set_strip_16(png);
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

std::vector<png_bytep> rows_of(std::uint8_t* pixels, int width, int height) {
  std::vector<png_bytep> rows(static_cast<std::size_t>(height));
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels + y * 4 * static_cast<std::size_t>(width);
  return rows;
}

[[noreturn]] void refuse(const Place& place, const std::string& wrong) {
  throw InputError("not-a-png", place, wrong, "Give an intact PNG file.");
}

struct Header {
  std::size_t width = 0, height = 0, depth = 0;
};

/// Of the first chunk, before anything is unpacked.
Header header_of(std::string_view bytes, const Place& place) {
  constexpr std::size_t kind_at = 12, width_at = 16, height_at = 20, depth_at = 24;
  if (bytes.size() <= depth_at || bytes.substr(kind_at, 4) != "IHDR") refuse(place, "the PNG's header is broken");
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (const char c : bytes.substr(at, 4)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
  };
  const Header header{number(width_at), number(height_at), static_cast<unsigned char>(bytes[depth_at])};
  if (header.width == 0 || header.height == 0) refuse(place, "the PNG's header is broken");
  constexpr std::size_t most = most_picture_side;
  if (header.width > most || header.height > most)
    throw InputError("picture-too-large", place, fmt::format("{} x {} pixels", header.width, header.height),
                     fmt::format("At most {} a side can be read.", most_picture_side));
  // At least so many bits a pixel come out of the packed ones; room for a gigabyte of pixels is not asked for on a
  // header's word alone.
  const std::size_t least = header.depth * header.width * header.height / 8;
  if (least / limits::compression_ratio > bytes.size())
    refuse(place, fmt::format("{} x {} pixels cannot be in {} bytes", header.width, header.height, bytes.size()));
  return header;
}

}  // namespace

std::string png_bytes(const Image& image) {
  std::string bytes;
  Complaint complaint;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint, fail, warn);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  bool done = false;
  if (info) {
    png_set_write_fn(png, &bytes, append, nullptr);
    // libpng only reads them, but asks for what may be written.
    std::vector<png_bytep> rows = rows_of(const_cast<std::uint8_t*>(image.rgba.data()), image.width, image.height);
    done = encode(png, info, image, rows.data());
  }
  png_destroy_write_struct(&png, &info);
  if (!done)
    throw InternalError(fmt::format("a picture of {} x {} pixels cannot be encoded: {}", image.width, image.height,
                                    complaint.words.data()));
  return bytes;
}

void write_png(const Image& image, const std::string& file) {
  AtomicFile target(file);
  target.write(png_bytes(image));
  target.commit();
}

Image read_png(const std::string& file) {
  const std::string bytes = read_file(file, most_png_bytes);
  Place place;
  place.file = file;
  if (!std::string_view(bytes).starts_with(png_signature))
    throw InputError("not-a-png", place, "this is no PNG", "Give a PNG file.");
  const Header header = header_of(bytes, place);
  Image image(static_cast<int>(header.width), static_cast<int>(header.height));
  std::string_view left = bytes;
  Complaint complaint;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint, fail, warn);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  bool done = false;
  if (info) {
    png_set_read_fn(png, &left, take);
    png_set_user_limits(png, most_picture_side, most_picture_side);
    png_set_chunk_malloc_max(png, most_chunk_bytes);
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
    std::vector<png_bytep> rows = rows_of(image.rgba.data(), image.width, image.height);
    done = decode(png, info, rows.data());
  }
  png_destroy_read_struct(&png, &info, nullptr);
  if (!done) refuse(place, complaint.words.data());
  if (complaint.pixels_left) refuse(place, "its pixels unpack to more than its size makes");
  return image;
}

}  // namespace odontoscope
