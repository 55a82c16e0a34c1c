// What an error or a warning advises is done, and must give the right model: the very contours that the input gives
// whose fault was never made.

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/app/program.h"
#include "tests/exchange/made_files.h"
#include "tests/volume/dicom_bytes.h"
#include "tests/volume/volume_files.h"

namespace odontoscope::testing_support {
namespace {

namespace fs = std::filesystem;
using test::DicomSlice;
using test::MetaImage;
using test::Nifti;
using test::Nrrd;
using Words = std::vector<std::string>;

struct Files {
  const TemporaryFolder& folder;
  void operator()(const std::string& name, const std::string& bytes) const {
    fs::create_directories((folder / name).parent_path());
    put(folder / name, bytes);
  }
};

struct Remedy {
  const char* name;
  std::function<void(const Files&)> files;
  Words wrong;         // what is tried first, -o left to the test
  const char* advice;  // part of what is said then, on either output
  Words followed;      // as it advises
  Words right;         // of an input without the fault
};

const std::string spaced = "space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0.25,0) (0,0,2)\n";
const Words iso{"--iso", "30.5"}, middle{"--iso", "11.5"};  // of 1 to 60, and of 0 to 35

Words contours(const std::string& file, const Words& more = {}, const Words& level = iso) {
  Words words{"contours", file};
  words.insert(words.end(), level.begin(), level.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Three slices 2 mm apart, each with its number, upwards.
void put_series(const Files& put, const std::string& folder, const std::function<void(DicomSlice&)>& change = {}) {
  for (int n = 0; n < 3; ++n) {
    DicomSlice slice;
    const std::string number = std::to_string(n + 1);
    slice.position = "0\\0\\" + std::to_string(2 * n);
    slice.instance = slice.series + "." + number;
    for (int pixel = 0; pixel < 12; ++pixel)
      slice.pixels[static_cast<std::size_t>(pixel)] = static_cast<std::int16_t>(12 * n + pixel);
    if (change) change(slice);
    slice.more = test::dicom_element(0x20, 0x13, "IS", number) + slice.more;
    put(folder + "/IM" + number, slice.bytes());
  }
}

/// An element's tag made another, private and meaningless one: as if it were not there.
void leave_out(std::string& bytes, const char (&tag)[5]) {
  const std::size_t at = bytes.find(std::string(tag, 4));
  if (at != bytes.npos) bytes[at] = '\x21';
}

std::string labels() {
  std::string pixels(60, '\0');
  for (std::size_t n = 0; n < pixels.size(); ++n) pixels[n] = n % 5 > 0 && n % 5 < 4 ? (n < 40 ? 1 : 2) : 0;
  return pixels;
}

/// A block 3 mm high as STL in text, without its last `missing` triangles.
std::string box_stl(double side, std::size_t missing) {
  const double s = side;
  const double corner[8][3] = {{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0}, {0, 0, 3}, {s, 0, 3}, {s, s, 3}, {0, s, 3}};
  const int faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                            {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  std::string text = "solid box\n";
  for (std::size_t n = 0; n + missing < 12; ++n) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int c : faces[n])
      text += "vertex " + std::to_string(corner[c][0]) + " " + std::to_string(corner[c][1]) + " " +
              std::to_string(corner[c][2]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

std::vector<Remedy> of_volumes() {
  return {
      {"NrrdWithoutSpacing",
       [](const Files& put) {
         put("a.nrrd", Nrrd{}.bytes());
         put("b.nrrd", Nrrd{.more = spaced}.bytes());
       },
       contours("a.nrrd"), "1 mm is assumed; --spacing X,Y,Z gives the true one",
       contours("a.nrrd", {"--spacing", "0.5,0.25,2"}), contours("b.nrrd")},
      {"NrrdOfUnknownUnit",
       [](const Files& put) {
         put("a.nrrd", Nrrd{.more = "space units: \"foot\" \"foot\" \"foot\"\n" + spaced}.bytes());
         put("b.nrrd", Nrrd{.more = spaced}.bytes());
       },
       contours("a.nrrd"), "(--spacing X,Y,Z). [unknown-unit]", contours("a.nrrd", {"--spacing", "0.5,0.25,2"}),
       contours("b.nrrd")},
      {"MetaImageOfUnknownUnit",
       [](const Files& put) {
         put("a.mha", MetaImage{.more = "ElementSpacing = 1 1 1\nDistanceUnits = foot\n"}.bytes());
         put("b.mha", MetaImage{.more = "ElementSpacing = 0.5 0.25 2\n"}.bytes());
       },
       contours("a.mha"), "(--spacing X,Y,Z). [unknown-unit]", contours("a.mha", {"--spacing", "0.5,0.25,2"}),
       contours("b.mha")},
      {"MetaImageWithoutSpacing",
       [](const Files& put) {
         put("a.mha", MetaImage{}.bytes());
         put("b.mha", MetaImage{.more = "ElementSpacing = 0.5 0.25 2\n"}.bytes());
       },
       contours("a.mha"), "--spacing X,Y,Z gives the true one", contours("a.mha", {"--spacing", "0.5,0.25,2"}),
       contours("b.mha")},
      {"NiftiWithoutSpacing",
       [](const Files& put) {
         put("a.nii", Nifti{.pixdim = {1, 0, 0, 0}}.bytes());
         put("b.nii", Nifti{.pixdim = {1, 0.5f, 0.25f, 2}}.bytes());
       },
       contours("a.nii"), "(--spacing X,Y,Z). [bad-spacing]", contours("a.nii", {"--spacing", "0.5,0.25,2"}),
       contours("b.nii")},
      {"PixelsOutside",
       [](const Files& put) {
         put("pixels.raw", Nrrd{}.pixels);
         put("in/a.nhdr", Nrrd{.more = spaced + "data file: ../pixels.raw\n", .pixels = {}}.bytes());
         put("b.nrrd", Nrrd{.more = spaced}.bytes());
       },
       contours("in/a.nhdr"), "or give --allow-outside", contours("in/a.nhdr", {"--allow-outside"}),
       contours("b.nrrd")},
      {"SeveralSeriesByNumber",
       [](const Files& put) {
         put_series(put, "a");
         put_series(put, "b");
         put("a/other", DicomSlice{.series = "9.9"}.bytes());
       },
       contours("a", {}, middle), "Choose one by its number (--series N), or give a file of it",
       contours("a", {"--series", "1"}, middle), contours("b", {}, middle)},
      {"SeveralSeriesByFile",
       [](const Files& put) {
         put_series(put, "a");
         put_series(put, "b");
         put("a/other", DicomSlice{.series = "9.9"}.bytes());
       },
       contours("a", {}, middle), "or give a file of it", contours("a/IM2", {}, middle), contours("b", {}, middle)},
      {"NoSuchSeries",
       [](const Files& put) {
         put_series(put, "a");
         put_series(put, "b");
       },
       contours("a", {"--series", "7"}, middle), "Choose one by its number (--series N)",
       contours("a", {"--series", "1"}, middle), contours("b", {}, middle)},
      {"DamagedFileBeside",
       [](const Files& put) {
         put_series(put, "a");
         put_series(put, "b");
         put("a/odd", DicomSlice{}.bytes().substr(0, 330));
       },
       contours("a", {}, middle), "give a file of that one, or --series 1", contours("a", {"--series", "1"}, middle),
       contours("b", {}, middle)},
      {"DicomWithoutPlaces",
       [](const Files& put) {
         for (int n = 1; n <= 3; ++n) {
           DicomSlice slice{.spacing = "1\\1",
                            .instance = "1.2.3.4." + std::to_string(n),
                            .more = test::dicom_element(0x20, 0x13, "IS", std::to_string(n))};
           for (int pixel = 0; pixel < 12; ++pixel)
             slice.pixels[static_cast<std::size_t>(pixel)] = static_cast<std::int16_t>(12 * (n - 1) + pixel);
           std::string bytes = slice.bytes();
           leave_out(bytes, "\x20\0\x32\0");
           leave_out(bytes, "\x18\0\x50\0");
           put("a/IM" + std::to_string(4 - n), bytes);  // names run the other way
         }
         put_series(put, "b");
       },
       contours("a", {}, {"--iso", "20.5"}), "taken in the order of their numbers, upwards. [no-positions]",
       contours("a", {"--spacing", "0.25,0.5,2"}, {"--iso", "20.5"}), contours("b", {}, {"--iso", "20.5"})},
      {"IsoBeyondTheValues", [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced}.bytes()); },
       contours("a.nrrd", {}, {"--iso", "1000"}), "values run from 1 to 60", contours("a.nrrd"), contours("a.nrrd")},
      {"NoLevel",
       [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced}.bytes()); },
       {"contours", "a.nrrd"},
       "Give --iso T (or --iso auto) for an image",
       contours("a.nrrd", {}, {"--iso", "auto"}),
       contours("a.nrrd", {}, {"--iso", "31"})},
      {"TooFewClasses", [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced, .pixels = labels()}.bytes()); },
       contours("a.nrrd", {}, {"--iso", "auto:5/4"}), "Give a value (--iso T)",
       contours("a.nrrd", {}, {"--iso", "0.5"}), contours("a.nrrd", {}, {"--iso", "0.5"})},
      {"ALabelMapTakenForAnImage",
       [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced, .pixels = labels()}.bytes()); },
       contours("a.nrrd", {}, {"--iso", "1"}), "--label N[=NAME] takes one of them",
       contours("a.nrrd", {}, {"--label", "1=tooth"}), contours("a.nrrd", {}, {"--label", "1=tooth"})},
      {"NoSuchLabel", [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced, .pixels = labels()}.bytes()); },
       contours("a.nrrd", {}, {"--label", "7"}), "Give a label that is there (--label N[=NAME])",
       contours("a.nrrd", {}, {"--label", "1"}), contours("a.nrrd", {}, {"--label", "1"})},
      {"MinAreaLeavesNothing", [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced}.bytes()); },
       contours("a.nrrd", {"--min-area", "1000"}), "Give a smaller --min-area", contours("a.nrrd", {"--min-area", "1"}),
       contours("a.nrrd")},
      {"BoxBesideTheVolume", [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced}.bytes()); },
       contours("a.nrrd", {"--crop", "50,60,0,1,0,4"}), "the volume reaches from 0 to 2 mm",
       contours("a.nrrd", {"--crop", "0,2,-1,1,0,4"}), contours("a.nrrd")},
      {"CheckOfAVolume",
       [](const Files& put) { put("a.nrrd", Nrrd{.more = spaced}.bytes()); },
       {"check", "a.nrrd"},
       "odontoscope contours a.nrrd --iso T -o FILE.json",
       contours("a.nrrd"),
       contours("a.nrrd")},
  };
}

std::vector<Remedy> of_meshes_and_contours() {
  const auto doubled = [](const Files& put) {
    put("a.json", cube_stack("[[0,0],[1,0],[1,0],[1,1],[0,1]]"));
    put("b.json", cube_stack());
  };
  const auto boxes = [](const Files& put) {
    put("a.stl", box_stl(4, 1));
    put("b.stl", box_stl(4, 0));
  };
  const auto two_regions = [](const Files& put) {
    std::vector<made::RoiOfSet> rois{{"Heart", {}}, {"Lung", {}}};
    for (int z = 0; z < 3; ++z) rois[0].contours.push_back({made::square(0, 0, z, 4), "4"});
    put("b.dcm", made::rtstruct({rois[0]}));
    rois[1].contours.push_back({"0\\0\\0\\4\\0\\1\\4\\4\\2\\0\\4\\3", "4"});  // tilted against the others
    rois[1].contours.push_back({"0\\0\\5\\4\\0\\9\\4\\4\\5\\0\\4\\5", "4"});
    put("a.dcm", made::rtstruct(rois));
  };
  return {
      {"MeshWithoutPlanes",
       boxes,
       {"contours", "b.stl"},
       "Give --spacing-z D, or --at Z for each plane",
       {"contours", "b.stl", "--spacing-z", "1"},
       {"contours", "b.stl", "--at", "0.5", "--at", "1.5", "--at", "2.5"}},
      {"OpenMesh",
       boxes,
       {"contours", "a.stl", "--spacing-z", "1"},
       "or give --repair. [open-surface]",
       {"contours", "a.stl", "--spacing-z", "1", "--repair", "--widest-gap", "5"},
       {"contours", "b.stl", "--spacing-z", "1"}},
      {"GapTooWide",
       boxes,
       {"contours", "a.stl", "--spacing-z", "1", "--repair"},
       "allow more with --widest-gap. [gap-too-wide]",
       {"contours", "a.stl", "--spacing-z", "1", "--repair", "--widest-gap", "5"},
       {"contours", "b.stl", "--spacing-z", "1"}},
      {"DoubledPoint",
       doubled,
       {"contours", "a.json"},
       "Or give --repair, which tells what it changes",
       {"contours", "a.json", "--repair"},
       {"contours", "b.json"}},
      {"RegionsOfOtherPlanes",
       two_regions,
       {"contours", "a.dcm"},
       "choose regions with --structure",
       {"contours", "a.dcm", "--structure", "Heart"},
       {"contours", "b.dcm"}},
  };
}

class Remedies : public ProgramTest, public ::testing::WithParamInterface<Remedy> {
 protected:
  Ending with_output(Words words, const std::string& output) {
    if (words[0] != "check") words.insert(words.end(), {"-o", output});
    return odontoscope(words);
  }
};

TEST_P(Remedies, GiveTheRightModel) {
  const Remedy& remedy = GetParam();
  remedy.files(Files{folder});
  const Ending wrong = with_output(remedy.wrong, "wrong.json");
  EXPECT_TRUE(wrong.says(remedy.advice) || wrong.complains(remedy.advice)) << wrong.out << wrong.err;
  const Ending followed = with_output(remedy.followed, "followed.json");
  ASSERT_EQ(followed.exit_code, 0) << followed.err;
  const Ending right = with_output(remedy.right, "right.json");
  ASSERT_EQ(right.exit_code, 0) << right.err;
  EXPECT_EQ(bytes_of("followed.json"), bytes_of("right.json"));
  if (wrong.exit_code == 0)
    EXPECT_NE(bytes_of("wrong.json"), bytes_of("right.json"))
        << "the fault makes no difference: the test shows nothing";
}

const auto name_of = [](const auto& test) { return std::string(test.param.name); };
INSTANTIATE_TEST_SUITE_P(OfVolumes, Remedies, ::testing::ValuesIn(of_volumes()), name_of);
INSTANTIATE_TEST_SUITE_P(OfMeshesAndContours, Remedies, ::testing::ValuesIn(of_meshes_and_contours()), name_of);

class RemediesOfModels : public ProgramTest {};

/// A canal one voxel wide that runs through the corners of voxels: a mask of 1 with voxels of 0.
TEST_F(RemediesOfModels, ACanalThatFallsToPiecesIsWholeOnAFinerGrid) {
  std::string text = "NRRD0004\ntype: short\ndimension: 3\nsizes: 12 12 10\nencoding: text\n\n";
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i)
        text += i > 0 && j > 0 && i < 11 && j < 11 && !(k > 1 && k < 8 && i == 1 + k && j == 1 + k) ? "1 " : "0 ";
  given("a.nrrd", text);
  const Ending fallen = odontoscope(
      {"reconstruct", "a.nrrd", "--iso", "0.5", "--correspondence", "medial", "--between", "delaunay", "-o", "a.glb"});
  EXPECT_TRUE(
      fallen.says("--resample at a quarter of a voxel, with an --iso nearer to the values around it, keeps it whole"))
      << fallen.out;
  EXPECT_TRUE(fallen.says("in 7 closed surfaces")) << fallen.out;
  const Ending whole = odontoscope({"reconstruct", "a.nrrd", "--iso", "0.9", "--resample", "0.25", "-o", "b.glb"});
  EXPECT_TRUE(whole.says("in 2 closed surfaces")) << whole.out << whole.err;
  EXPECT_FALSE(whole.says("may fall to pieces")) << whole.out;
}

/// Six slices of one polygon round (shift * z, 0).
std::string leaning(double shift, int corners) {
  std::string text = R"({"format":"odontoscope.contours","version":1,"unit":"mm","slices":[)";
  for (int z = 0; z < 6; ++z) {
    text += std::string(z == 0 ? "" : ",") + "{\"z\":" + std::to_string(z) + ",\"contours\":[{\"points\":[";
    for (int n = 0; n < corners; ++n) {
      const double turn = 2 * std::numbers::pi * n / corners;
      text += (n == 0 ? "[" : ",[") + std::to_string(shift * z + std::cos(turn)) + "," +
              std::to_string(std::sin(turn)) + "]";
    }
    text += "]}]}";
  }
  return text + "]}";
}

TEST_F(RemediesOfModels, ThinPlatesBecomeOnePieceWithOverlap) {
  given("a.json", leaning(1.5, 32));
  const Ending plates = odontoscope({"reconstruct", "a.json", "--correspondence", "reverse", "-o", "a.glb"});
  ASSERT_TRUE(plates.says("thin plates")) << plates.out;
  const Ending whole = odontoscope({"reconstruct", "a.json", "--correspondence", "overlap", "-o", "b.glb"});
  EXPECT_TRUE(whole.says("in 1 closed surface")) << whole.out;
}

/// So few corners that none shows an overlap: only the user knows.
TEST_F(RemediesOfModels, ThinPlatesBecomeOnePieceWithLinks) {
  given("a.json", leaning(1.5, 4));
  const Ending plates = odontoscope({"reconstruct", "a.json", "--correspondence", "overlap", "-o", "a.glb"});
  ASSERT_TRUE(plates.says("thin plates")) << plates.out;
  std::string links = R"({"format":"odontoscope.links","version":1,"links":[)";
  for (int slice = 0; slice < 5; ++slice)
    links += std::string(slice == 0 ? "" : ",") + "{\"slice\":" + std::to_string(slice) +
             ",\"lower\":0,\"upper\":0,\"connect\":true}";
  given("links.json", links + "]}");
  const Ending whole = odontoscope({"reconstruct", "a.json", "--links", "links.json", "-o", "b.glb"});
  EXPECT_TRUE(whole.says("in 1 closed surface")) << whole.out << whole.err;
}

TEST_F(RemediesOfModels, UsageErrorsNameOptionsThatWork) {
  given("cube.json", cube_stack());
  const std::vector<std::pair<Words, Words>> pairs{
      {{"reconstruct", "cube.json", "--grid", "16", "-o", "a.glb"},
       {"reconstruct", "cube.json", "--grid", "16", "--method", "db", "-o", "a.glb"}},
      {{"reconstruct", "cube.json", "--method", "db", "--triangles", "9", "-o", "a.glb"},
       {"reconstruct", "cube.json", "--method", "db", "--decimate", "9", "-o", "a.glb"}},
      {{"reconstruct", "cube.json", "--compress", "-o", "a.stl"},
       {"reconstruct", "cube.json", "--compress", "-o", "a.stl", "-o", "model.glb"}},
  };
  for (const auto& [wrong, followed] : pairs) {
    EXPECT_EQ(odontoscope(wrong).exit_code, 2) << wrong[2];
    EXPECT_EQ(odontoscope(followed).exit_code, 0) << wrong[2];
  }
}

}  // namespace
}  // namespace odontoscope::testing_support
