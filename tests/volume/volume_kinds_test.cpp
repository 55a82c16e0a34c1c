// Headers as programs write them: every space, unit and packing gives the same volume in the same place; what cannot be
// known is said or refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/volume/label_names.h"
#include "recon/volume/read_volume.h"
#include "tests/output/temporary_folder.h"
#include "tests/volume/volume_files.h"

namespace odontoscope::test {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

Volume read(const std::string& name, const std::string& bytes, const ReadVolumeOptions& options = {}) {
  const TemporaryFolder folder;
  put(folder / name, bytes);
  return read_volume((folder / name).string(), options);
}

std::string cause_of(const std::string& name, const std::string& bytes, const ReadVolumeOptions& options = {}) {
  try {
    read(name, bytes, options);
    return "none";
  } catch (const InputError& error) {
    return error.cause();
  }
}

/// Value of the voxel whose centre is at `at`, or -1.
float value_at(const Volume& volume, const std::array<double, 3>& at) {
  const std::array<double, 3> origin{volume.origin.x, volume.origin.y, volume.origin.z};
  std::array<std::size_t, 3> n{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double index = (at[axis] - origin[axis]) / volume.spacing[axis];
    if (std::abs(index - std::round(index)) > 1e-4 || index < -0.5 || index > double(volume.size[axis]) - 0.5)
      return -1;
    n[axis] = std::size_t(std::lround(index));
  }
  return volume.slice(n[2])[n[1] * volume.size[0] + n[0]];
}

/// Voxel (i, j, k) lies at (10 + 0.5 i, 20 + 2 j, 30 + 3 k) mm, LPS.
void expect_in_place(const Volume& volume, const std::string& what) {
  for (std::size_t v = 0; v < telling_voxels().size(); ++v) {
    ASSERT_EQ(value_at(volume, {10 + 0.5 * double(v % 5), 20 + 2 * double(v / 5 % 4), 30 + 3 * double(v / 20)}),
              float(1 + v))
        << what;
  }
}

std::string triple(double x, double y, double z) {
  return "(" + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + ")";
}

/// A space in which LPS has the signs given, in units of which a millimetre has `scale`.
std::string geometry(const std::string& space, std::array<double, 3> s, double scale = 1) {
  return "space: " + space + "\nspace directions: " + triple(s[0] * 0.5 * scale, 0, 0) + " " +
         triple(0, s[1] * 2 * scale, 0) + " " + triple(0, 0, s[2] * 3 * scale) +
         "\nspace origin: " + triple(s[0] * 10 * scale, s[1] * 20 * scale, s[2] * 30 * scale) + "\n";
}

TEST(VolumeKinds, EverySpaceOfNrrdIsTurnedIntoLeftPosteriorSuperior) {
  const std::array<double, 3> lps{1, 1, 1}, ras{-1, -1, 1}, las{1, -1, 1};
  const std::vector<std::pair<std::string, std::array<double, 3>>> spaces{{"left-posterior-superior", lps},
                                                                          {"LPS", lps},
                                                                          {"right-anterior-superior", ras},
                                                                          {"RAS", ras},
                                                                          {"left-anterior-superior", las},
                                                                          {"LAS", las},
                                                                          {"Left-Anterior-Superior", las},
                                                                          {"scanner-xyz", lps},
                                                                          {"3D-right-handed", lps},
                                                                          {"left-anterior-superior-time", las},
                                                                          {"RAST", ras}};
  for (const auto& [space, signs] : spaces)
    expect_in_place(read("a.nrrd", Nrrd{.more = geometry(space, signs)}.bytes()), space);
  EXPECT_EQ(cause_of("a.nrrd", Nrrd{.more = geometry("3D-left-handed", lps)}.bytes()), "left-handed-space");
  EXPECT_EQ(cause_of("a.nrrd", Nrrd{.more = geometry("somewhere", lps)}.bytes()), "unreadable-volume");
}

TEST(VolumeKinds, EveryUnitOfNrrdIsTurnedIntoMillimetres) {
  const std::vector<std::pair<std::string, double>> units{
      {"mm", 1},       {"millimeters", 1}, {"um", 1e3},         {"\xC2\xB5m", 1e3}, {"\xCE\xBCm", 1e3},
      {"micron", 1e3}, {"microns", 1e3},   {"micrometer", 1e3}, {"UM", 1e3},        {"nm", 1e6},
      {"cm", 0.1},     {"m", 1e-3},        {"meters", 1e-3}};
  for (const auto& [unit, scale] : units) {
    const std::string quoted = "\"" + unit + "\"";
    const std::string units_line = "space units: " + quoted + " " + quoted + " " + quoted + "\n";
    const std::string more = "space: left-posterior-superior\nspace directions: " + triple(0.5 * scale, 0, 0) + " " +
                             triple(0, 2 * scale, 0) + " " + triple(0, 0, 3 * scale);
    std::ostringstream exact;
    exact << "space: left-posterior-superior\n"
          << units_line << "space directions: (" << 0.5 * scale << ",0,0) (0," << 2 * scale << ",0) (0,0," << 3 * scale
          << ")\nspace origin: (" << 10 * scale << "," << 20 * scale << "," << 30 * scale << ")\n";
    expect_in_place(read("a.nrrd", Nrrd{.more = exact.str()}.bytes()), unit);
    std::ostringstream plain;
    plain << "units: " << quoted << " " << quoted << " " << quoted << "\nspacings: " << 0.5 * scale << " " << 2 * scale
          << " " << 3 * scale << "\n";
    const Volume volume = read("a.nrrd", Nrrd{.more = plain.str()}.bytes());
    EXPECT_NEAR(volume.spacing[0], 0.5, 1e-9) << unit;
    EXPECT_NEAR(volume.spacing[2], 3, 1e-9) << unit;
    EXPECT_TRUE(volume.remarks.empty());
  }
}

TEST(VolumeKinds, AnUnknownUnitIsRefusedAndTheRemedyGivesTheRightVolume) {
  const std::string bytes = Nrrd{.more = "space units: \"furlong\" \"furlong\" \"furlong\"\n" +
                                         geometry("left-posterior-superior", {1, 1, 1}, 7)}
                                .bytes();
  EXPECT_EQ(cause_of("a.nrrd", bytes), "unknown-unit");
  expect_in_place(read("a.nrrd", bytes, {.spacing = std::array<double, 3>{0.5, 2, 3}}), "furlong");
}

TEST(VolumeKinds, WhatAFileDoesNotSayIsSaid) {
  const auto remarks = [](const std::string& name, const std::string& bytes) {
    std::string all;
    for (const std::string& remark : read(name, bytes).remarks) all += remark + "\n";
    return all;
  };
  EXPECT_NE(remarks("a.nrrd", Nrrd{}.bytes()).find("no spacing along axis 1 and 2 and 3: 1 mm is assumed"),
            std::string::npos);
  EXPECT_NE(remarks("a.nrrd", Nrrd{.more = "spacings: 2 2 nan\n"}.bytes()).find("along axis 3"), std::string::npos);
  EXPECT_NE(remarks("a.nrrd", Nrrd{.more = "spacings: 2 2 2\n"}.bytes()).find("no unit of length"), std::string::npos);
  EXPECT_EQ(remarks("a.nrrd", Nrrd{.more = geometry("LPS", {1, 1, 1})}.bytes()), "");
  EXPECT_NE(remarks("a.mha", MetaImage{}.bytes()).find("no spacing"), std::string::npos);
  EXPECT_EQ(remarks("a.mha", MetaImage{.more = "ElementSpacing = 1 1 1\n"}.bytes()), "");
  EXPECT_NE(remarks("a.nii", Nifti{}.bytes()).find("no unit of length"), std::string::npos);
}

TEST(VolumeKinds, NrrdWithoutSpacingsTakesThemFromItsEnds) {
  // Cells lie between the ends, nodes on them.
  const Volume cells = read("a.nrrd", Nrrd{.more = "axis mins: 0 0 0\naxis maxs: 2.5 8 9\n"}.bytes());
  EXPECT_EQ(cells.spacing, (std::array<double, 3>{0.5, 2, 3}));
  EXPECT_EQ(cells.origin, (Point3{0.25, 1, 1.5}));
  const Volume nodes =
      read("a.nrrd", Nrrd{.more = "axis mins: 0 0 0\naxis maxs: 2 6 6\ncenters: node node node\n"}.bytes());
  EXPECT_EQ(nodes.spacing, (std::array<double, 3>{0.5, 2, 3}));
  EXPECT_EQ(nodes.origin, (Point3{0, 0, 0}));
}

TEST(VolumeKinds, PixelsMayLieInManyFiles) {
  const std::string pixels = bytes_of(telling_voxels()), geo = geometry("LPS", {1, 1, 1});
  const TemporaryFolder folder;
  for (int k = 0; k < 3; ++k)
    put(folder / ("s" + std::to_string(k + 1) + ".raw"), pixels.substr(std::size_t(20 * k), 20));
  for (int k = 0; k < 3; ++k)
    put(folder / ("p00" + std::to_string(9 - k) + ".raw"), pixels.substr(std::size_t(20 * k), 20));
  const std::string head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\n" + geo + "encoding: raw\n";
  put(folder / "list.nhdr", head + "data file: LIST\ns1.raw\ns2.raw\ns3.raw\n");
  put(folder / "crlf.nhdr",
      "NRRD0004\r\ntype: uint8\r\ndimension: 3\r\nsizes: 5 4 3\r\nspace: LPS\r\nspace directions: (0.5,0,0) (0,2,0) "
      "(0,0,3)\r\nspace origin: (10,20,30)\r\nencoding: raw\r\ndata file: LIST\r\ns1.raw\r\ns2.raw\r\ns3.raw\r\n");
  put(folder / "up.nhdr", head + "data file: s%d.raw 1 3 1\n");
  put(folder / "down.nhdr", head + "datafile: p%03d.raw 9 7 -1\n");
  const std::string meta =
      "ObjectType = Image\nNDims = 3\nElementSpacing = 0.5 2 3\nOffset = 10 20 30\nDimSize = 5 4 3\nElementType = "
      "MET_UCHAR\n";
  put(folder / "list.mhd", meta + "ElementDataFile = LIST\ns1.raw\ns2.raw\ns3.raw\n");
  put(folder / "list2.mhd", meta + "ElementDataFile = LIST 2\ns1.raw\ns2.raw\ns3.raw\n");
  put(folder / "pattern.mhd", meta + "ElementDataFile = s%d.raw 1 3 1\n");
  for (const char* name : {"list.nhdr", "crlf.nhdr", "up.nhdr", "down.nhdr", "list.mhd", "list2.mhd", "pattern.mhd"})
    expect_in_place(read_volume((folder / name).string()), name);
  put(folder / "few.nhdr", head + "data file: s%d.raw 1 2 1\n");
  put(folder / "nonsense.nhdr", head + "data file: s%s%n.raw 1 3 1\n");
  put(folder / "endless.nhdr", head + "data file: s%d.raw 1 999999 1\n");
  for (const char* name : {"few.nhdr", "nonsense.nhdr", "endless.nhdr"})
    EXPECT_THROW(read_volume((folder / name).string()), InputError) << name;
}

TEST(VolumeKinds, AHeaderNamesNoFileOutsideItsFolderUnlessItMay) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "inner/below");
  put(folder / "secret.raw", bytes_of(telling_voxels()));
  put(folder / "inner/below/own.raw", bytes_of(telling_voxels()));
  std::filesystem::create_symlink(folder / "secret.raw", folder / "inner/link.raw");
  const auto nrrd = [](const std::string& file) {
    return Nrrd{.more = "data file: " + file + "\n", .pixels = ""}.bytes();
  };
  const auto meta = [](const std::string& file) { return MetaImage{.data_file = file, .pixels = ""}.bytes(); };
  const std::string absolute = (folder / "secret.raw").string();
  for (const std::string& file :
       {std::string("../secret.raw"), absolute, std::string("below/../../secret.raw"), std::string("link.raw")}) {
    put(folder / "inner/a.nhdr", nrrd(file));
    put(folder / "inner/a.mhd", meta(file));
    for (const char* header : {"inner/a.nhdr", "inner/a.mhd"}) {
      try {
        read_volume((folder / header).string());
        ADD_FAILURE() << file;
      } catch (const InputError& error) {
        EXPECT_EQ(error.cause(), "outside-folder") << file;
      }
      EXPECT_EQ(read_volume((folder / header).string(), {.allow_outside = true}).values[1], 2) << file;
    }
  }
  put(folder / "inner/a.nhdr", nrrd("below/own.raw"));
  EXPECT_EQ(read_volume((folder / "inner/a.nhdr").string()).values[1], 2);
}

TEST(VolumeKinds, AnImageBesideItsHeaderIsNoLinkOutOfTheirFolderUnlessItMay) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "inner");
  put(folder / "secret.raw", bytes_of(telling_voxels()));
  std::filesystem::create_symlink(folder / "secret.raw", folder / "inner/a.img");
  put(folder / "inner/a.hdr", Nifti{.vox_offset = 0, .magic = "ni1", .pixels = ""}.bytes().substr(0, 348));
  for (const char* name : {"inner/a.hdr", "inner/a.img"}) {
    try {
      read_volume((folder / name).string());
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(error.cause(), "outside-folder") << name;
    }
    EXPECT_EQ(read_volume((folder / name).string(), {.allow_outside = true}).values[1], 2) << name;
  }
}

TEST(VolumeKinds, NrrdComesInEveryEncoding) {
  const std::string pixels = bytes_of(telling_voxels()), geo = geometry("LPS", {1, 1, 1});
  std::string hex, text;
  for (const unsigned value : telling_voxels()) {
    hex += "0123456789abcdef"[value / 16];
    hex += "0123456789ABCDEF"[value % 16];
    hex += value % 7 == 0 ? "\n" : "";
    text += std::to_string(value) + (value % 5 == 0 ? "\n" : " ");
  }
  expect_in_place(read("a.nrrd", Nrrd{.encoding = "hex", .more = geo, .pixels = hex}.bytes()), "hex");
  expect_in_place(read("a.nrrd", Nrrd{.encoding = "txt", .more = geo, .pixels = text}.bytes()), "text");
  expect_in_place(read("a.nrrd", Nrrd{.encoding = "gz", .more = geo, .pixels = gzip_packed(pixels)}.bytes()), "gz");
  expect_in_place(
      read("a.nrrd", Nrrd{.more = geo + "line skip: 2\nbyte skip: 3\n", .pixels = "one\ntwo\nabc" + pixels}.bytes()),
      "skips");
  expect_in_place(read("a.nrrd", Nrrd{.more = geo + "byte skip: -1\n", .pixels = "whatever" + pixels}.bytes()), "end");
  expect_in_place(
      read("a.nrrd",
           Nrrd{.encoding = "gzip", .more = geo + "byte skip: 3\n", .pixels = gzip_packed("abc" + pixels)}.bytes()),
      "skip within");
  expect_in_place(read("a.nrrd", gzip_packed(Nrrd{.more = geo}.bytes())), "whole file packed");
  EXPECT_EQ(cause_of("a.nrrd", Nrrd{.encoding = "bzip2"}.bytes()), "unreadable-volume");
  // Two bytes a number: in which order is said, or asked for.
  std::vector<std::uint16_t> wide;
  for (const std::uint8_t value : telling_voxels()) wide.push_back(static_cast<std::uint16_t>(value << 8));
  std::string big = Nrrd{.type = "uint16", .more = geo, .pixels = bytes_of(wide)}.bytes();
  big.replace(big.find("endian: little"), 14, "endian: big   ");
  expect_in_place(read("a.nrrd", big), "big endian");
  big.replace(big.find("endian: big   "), 14, "x-endian: none");
  EXPECT_EQ(cause_of("a.nrrd", big), "unreadable-volume");
}

/// NIfTI-2: the same fields in other places, wider.
std::string nifti2(std::int32_t units, const std::array<double, 12>& srow, std::int64_t offset) {
  std::string header(544, '\0');
  const auto set = [&header](std::size_t at, auto value) { std::memcpy(header.data() + at, &value, sizeof value); };
  set(0, std::int32_t{540});
  std::memcpy(header.data() + 4, "n+2\0\r\n\x1a\n", 8);
  set(12, std::int16_t{2});
  set(14, std::int16_t{8});
  for (std::size_t n = 0; n < 8; ++n) set(16 + 8 * n, std::array<std::int64_t, 8>{3, 5, 4, 3, 1, 1, 1, 1}[n]);
  for (std::size_t n = 0; n < 4; ++n) set(104 + 8 * n, 1.0);
  set(168, offset);
  set(348, std::int32_t{1});
  for (std::size_t n = 0; n < 12; ++n) set(400 + 8 * n, srow[n]);
  set(500, units);
  return header + bytes_of(telling_voxels());
}

/// Rows of an sform for the usual place, in units of which a millimetre has `scale`.
std::array<float, 12> usual_rows(float scale = 1) {
  std::array<float, 12> rows{-0.5f, 0, 0, -10, 0, -2, 0, -20, 0, 0, 3, 30};
  for (float& x : rows) x *= scale;
  return rows;
}

TEST(VolumeKinds, NiftiComesInBothVersionsAndEveryUnit) {
  struct Unit {
    int code;
    float scale;
  };
  for (const Unit unit : {Unit{0, 1}, Unit{1, 1e-3f}, Unit{2, 1}, Unit{3, 1e3f}, Unit{3 + 8, 1e3f}}) {
    std::string first = Nifti{.sform = 1, .srow = usual_rows(unit.scale)}.bytes();
    first[123] = static_cast<char>(unit.code);
    expect_in_place(read("a.nii", first), "NIfTI-1, unit " + std::to_string(unit.code));
    std::array<double, 12> rows{};
    for (std::size_t n = 0; n < 12; ++n) rows[n] = double(usual_rows()[n]) * double(unit.scale);
    expect_in_place(read("a.nii", nifti2(unit.code, rows, 544)), "NIfTI-2, unit " + std::to_string(unit.code));
    expect_in_place(read("a.nii.gz", gzip_packed(nifti2(unit.code, rows, 0))), "NIfTI-2 packed");
  }
  std::string odd = Nifti{.sform = 1, .srow = usual_rows()}.bytes();
  odd[123] = 6;
  EXPECT_EQ(cause_of("a.nii", odd), "unknown-unit");
}

TEST(VolumeKinds, NiftiHeadersThatProgramsReallyWriteAreRead) {
  Nifti usual{.sform = 1, .srow = usual_rows()};
  usual.pixdim = {-1, -0.5f, -2, 3};
  expect_in_place(read("a.nii", usual.bytes()), "negative spacing");
  usual.pixdim = {0, 0, 0, 0};
  expect_in_place(read("a.nii", usual.bytes()), "no spacing but in the sform");
  usual.vox_offset = 0;
  expect_in_place(read("a.nii", usual.bytes()), "no offset");
  expect_in_place(read("a.nii", gzip_packed(usual.bytes())), "packed without saying so");
  expect_in_place(read("scan.dat", usual.bytes()), "any name");
  expect_in_place(read("a.nii.gz", usual.bytes()), "called packed, and is not");
}

/// Quaternion (b, c, d) and offset for a turn by 180 degrees about z: RAS to LPS.
TEST(VolumeKinds, NiftiQformIsARotationAndTheScannersFormGoesFirst) {
  const auto with_q = [](std::string bytes, std::int16_t code, std::array<float, 6> q) {
    std::memcpy(bytes.data() + 252, &code, sizeof code);
    std::memcpy(bytes.data() + 256, q.data(), sizeof q);
    return bytes;
  };
  const std::array<float, 6> usual{0, 0, 1, -10, -20, 30};
  Nifti file{.pixdim = {1, 0.5f, 2, 3}};
  expect_in_place(read("a.nii", with_q(file.bytes(), 1, usual)), "qform");
  // An sform that is a registration to an atlas, or sheared by it, does not count against the scanner's.
  file.sform = 4;
  file.srow = {1, 0, 0, 5, 0, 1, 0, 5, 0, 0, 1, 5};
  expect_in_place(read("a.nii", with_q(file.bytes(), 1, usual)), "atlas");
  file.sform = 2;
  file.srow = {1, 0.5f, 0, 5, 0, 1, 0, 5, 0, 0, 1, 5};
  expect_in_place(read("a.nii", with_q(file.bytes(), 2, usual)), "sheared sform");
  // A third axis turned over: left-handed, as many scanners store.
  Nifti left{.pixdim = {-1, 0.5f, 2, 3}};
  const Volume volume = read("a.nii", with_q(left.bytes(), 1, {0, 0, 1, -10, -20, 30}));
  EXPECT_EQ(value_at(volume, {10, 20, 30}), 1);
  EXPECT_EQ(value_at(volume, {10, 20, 27}), 21);
  EXPECT_EQ(cause_of("a.nii", with_q(file.bytes(), 2, {2, 2, 2, 0, 0, 0})), "unreadable-volume");
}

TEST(VolumeKinds, MetaImageComesInAnyOrderAndUnit) {
  const std::string pixels = bytes_of(telling_voxels());
  const std::string tail = "Offset = 10 20 30\nElementSpacing = 0.5 2 3\nElementDataFile = LOCAL\n";
  expect_in_place(
      read("a.mha",
           "DimSize = 5 4 3\nComment = made by hand\nElementType = MET_UCHAR\nNDims = 3\nObjectType = Image\n" + tail +
               pixels),
      "order");
  expect_in_place(read("a.mha", "NDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\nCompressedData = True\n" + tail +
                                    zlib_packed(pixels)),
                  "no packed size");
  expect_in_place(
      read("a.txt", "ObjectType = Image\nNDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\n" + tail + pixels),
      "any name");
  expect_in_place(read("a.mha",
                       "NDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\nDistanceUnits = um\nOffset = 10000 20000 "
                       "30000\nElementSpacing = 500 2000 3000\nElementDataFile = LOCAL\n" +
                           pixels),
                  "um");
  std::string text;
  for (const int value : telling_voxels()) text += std::to_string(value) + " ";
  expect_in_place(
      read("a.mha", "NDims = 3\nBinaryData = False\nDimSize = 5 4 3\nElementType = MET_UCHAR\n" + tail + text), "text");
  expect_in_place(read("a.mha",
                       "NDims = 4\nDimSize = 5 4 3 1\nElementType = MET_UCHAR\nOffset = 10 20 30 0\nElementSpacing = "
                       "0.5 2 3 1\nElementDataFile = LOCAL\n" +
                           pixels),
                  "four axes");
}

TEST(VolumeKinds, OneImageOnEdgeIsNoVolume) {
  EXPECT_EQ(cause_of("a.nrrd", Nrrd{.sizes = "5 1 12"}.bytes()), "single-slice");
  EXPECT_EQ(cause_of("a.nrrd", Nrrd{.sizes = "1 5 12"}.bytes()), "single-slice");
  EXPECT_EQ(cause_of("a.nii", Nifti{.dim = {3, 5, 1, 12, 1, 1, 1, 1}}.bytes()), "single-slice");
}

TEST(VolumeKinds, FewBytesThatBecomeGigabytesAreRefusedBeforeTheyDo) {
  std::string member = gzip_packed(std::string(1u << 24, '\0')), bomb;
  for (int n = 0; n < 32; ++n) bomb += member;
  ASSERT_LT(bomb.size(), 1u << 20);
  EXPECT_EQ(cause_of("a.nrrd", Nrrd{.sizes = "1024 1024 512", .encoding = "gzip", .pixels = bomb}.bytes()),
            "too-well-packed");
  EXPECT_EQ(
      cause_of("a.nii.gz", gzip_packed(Nifti{.dim = {3, 1024, 1024, 512, 1, 1, 1, 1}, .pixels = ""}.bytes()) + bomb),
      "too-well-packed");
  EXPECT_EQ(
      cause_of("a.mha", MetaImage{.size = "1024 1024 512", .more = "CompressedData = True\n", .pixels = bomb}.bytes()),
      "too-well-packed");
}

TEST(VolumeKinds, SegmentsKeepTheNamesThatSlicerGaveThem) {
  const Volume volume =
      read("a.seg.nrrd", Nrrd{.more = "Segment0_Name:=Pulp "
                                      "chamber\nSegment0_LabelValue:=2\nSegment1_Name:=Dentine\nSegment1_LabelValue:="
                                      "1\nSegment10_Name:=odd\nSegment10_LabelValue:=x\n"}
                             .bytes());
  ASSERT_EQ(volume.labels.size(), 2u);
  EXPECT_EQ(volume.labels[0].value, 1);
  EXPECT_EQ(volume.labels[0].name, "Dentine");
  EXPECT_EQ(volume.labels[1].name, "Pulp chamber");
}

TEST(LabelNames, AreReadAsItkSnapWritesThem) {
  const auto labels = parse_label_names(
      "# ITK-SnAP Label Description File\n\n    0     0    0    0        0  0  0    \"Clear Label\"\n    2   0  255 0  "
      "1  1  1    \"Pulp \"\n    1   255    0    0        1  1  1    \"Dentine\"\r\n",
      "names.txt");
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].name, "Dentine");
  EXPECT_EQ(labels[1].value, 2);
  EXPECT_EQ(labels[1].name, "Pulp");
  for (const char* bad : {"1 2 3 \"few\"", "1 0 0 0 1 1 1 none", "x 0 0 0 1 1 1 \"x\"", "1e99 0 0 0 1 1 1 \"x\""})
    EXPECT_THROW(parse_label_names(bad, "f"), InputError) << bad;
}

}  // namespace
}  // namespace odontoscope::test
