// Wrong command lines: exit code 2, a message that helps, and nothing written.

#include "tests/app/program.h"

namespace odontoscope::testing_support {
namespace {

struct Mistake {
  const char* name;
  std::vector<std::string> arguments;
  const char* answer;  // part of the message
};

class Usage : public ProgramTest, public ::testing::WithParamInterface<Mistake> {};

TEST_P(Usage, IsRefusedWithAnAnswer) {
  given("cube.json", cube_stack());
  given("scan.nrrd", "never read");
  const Ending ending = odontoscope(GetParam().arguments);
  EXPECT_EQ(ending.exit_code, 2) << ending.err;
  EXPECT_TRUE(ending.complains(GetParam().answer)) << ending.err;
  EXPECT_TRUE(ending.complains("See odontoscope")) << ending.err;
  EXPECT_EQ(ending.out, "");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"cube.json", "scan.nrrd"}));
  EXPECT_EQ(bytes_of("cube.json"), cube_stack());
}

const Mistake mistakes[] = {
    {"MistypedSubcommand", {"reconstuct", "cube.json", "-o", "a.glb"}, "reconstruct"},
    {"ShortenedSubcommand", {"recon", "cube.json", "-o", "a.glb"}, "reconstruct"},
    {"FileInsteadOfSubcommand", {"cube.json"}, "odontoscope reconstruct cube.json -o"},
    {"TwoSubcommands", {"sample", "molar", "-o", "a.json", "check", "a.json"}, "too many"},
    {"UnknownOption", {"reconstruct", "cube.json", "-o", "a.glb", "--colour"}, "--colour"},
    {"MistypedOption", {"reconstruct", "cube.json", "-o", "a.glb", "--triangels", "9"}, "--triangles"},
    {"NoOutput", {"reconstruct", "cube.json"}, "--output"},
    {"NoInput", {"reconstruct", "-o", "a.glb"}, "INPUT"},
    {"UnknownEnding", {"reconstruct", "cube.json", "-o", "a.blend"}, ".glb"},
    {"NoEnding", {"reconstruct", "cube.json", "-o", "model"}, ".glb"},
    {"OneBadEndingOfTwo", {"reconstruct", "cube.json", "-o", "a.glb", "-o", "a.blend"}, ".blend"},
    {"ReportEnding", {"reconstruct", "cube.json", "-o", "a.glb", "--report", "a.txt"}, ".json"},
    {"SameOutputTwice", {"reconstruct", "cube.json", "-o", "a.glb", "-o", "./a.glb"}, "twice"},
    {"ReportIsOutput", {"contours", "scan.nrrd", "--iso", "1", "-o", "scan.nrrd"}, "both input and output"},
    {"OutputIsInput", {"reconstruct", "cube.json", "-o", "a.glb", "--report", "cube.json"}, "both input and output"},
    {"VolumeWithoutIso", {"reconstruct", "scan.nrrd", "-o", "a.glb"}, "--iso"},
    {"ContoursWithoutIso", {"contours", "scan.nrrd", "-o", "a.json"}, "--iso"},
    {"IsoIsNoNumber", {"contours", "scan.nrrd", "--iso", "bone", "-o", "a.json"}, "\"bone\" is no iso value"},
    {"IsoIsNan", {"contours", "scan.nrrd", "--iso", "nan", "-o", "a.json"}, "\"nan\" is no iso value"},
    {"IsoWithoutName", {"contours", "scan.nrrd", "--iso", "12=", "-o", "a.json"}, "name"},
    {"TwoIsoOfOneName", {"contours", "scan.nrrd", "--iso", "1", "--iso", "2", "-o", "a.json"}, "same name"},
    {"LabelIsNoNumber", {"contours", "scan.nrrd", "--label", "1.5", "-o", "a.json"}, "\"1.5\" is no label"},
    {"SpacingOfTwo", {"contours", "scan.nrrd", "--iso", "1", "--spacing", "1,1", "-o", "a.json"}, "--spacing"},
    {"SpacingOfFour", {"contours", "scan.nrrd", "--iso", "1", "--spacing", "1,1,1,1", "-o", "a.json"}, "--spacing"},
    {"SpacingNegative", {"contours", "scan.nrrd", "--iso", "1", "--spacing", "1,-1,1", "-o", "a.json"}, "--spacing"},
    {"MinAreaNegative", {"contours", "scan.nrrd", "--iso", "1", "--min-area", "-1", "-o", "a.json"}, "--min-area"},
    {"VolumeOptionWithoutIso", {"reconstruct", "cube.json", "--min-area", "4", "-o", "a.glb"}, "--iso"},
    {"UnknownCriterion", {"reconstruct", "cube.json", "--correspondence", "guess", "-o", "a.glb"}, "medial"},
    {"NoTriangles", {"reconstruct", "cube.json", "--triangles", "0", "-o", "a.glb"}, "--triangles"},
    {"ToursInAFormatWithoutCameras", {"reconstruct", "cube.json", "--tours", "-o", "a.stl"}, ".glb"},
    {"SeeingThroughAFormatWithoutIt", {"reconstruct", "cube.json", "--see-through", "-o", "a.stl"}, "--see-through"},
    {"CompressionOfAFormatWithoutIt", {"reconstruct", "cube.json", "--compress", "-o", "a.stl"}, "--compress"},
    {"ToursOfASolidWithoutAVoid", {"reconstruct", "cube.json", "--tours", "-o", "a.glb"}, "no void"},
    {"TogetherWithItself", {"reconstruct", "cube.json", "--together", "tooth", "-o", "a.glb"}, "--together"},
    {"NoThreads", {"--threads", "0", "reconstruct", "cube.json", "-o", "a.glb"}, "--threads"},
    {"ThreadsInWords", {"reconstruct", "cube.json", "-o", "a.glb", "--threads", "many"}, "--threads"},
    {"UnknownTooth", {"sample", "canine", "-o", "a.json"}, "molar"},
    {"SampleEnding", {"sample", "molar", "-o", "a.glb"}, ".json"},
    {"SampleSpacing", {"sample", "molar", "--slice-spacing", "0", "-o", "a.json"}, "spacing"},
    {"TwoFilesBehindOneO", {"reconstruct", "cube.json", "-o", "a.glb", "b.stl"}, "-o A -o B"},
    {"SwappedLetters", {"veiw"}, "Did you mean view?"},
    {"StandardInput", {"check", "-"}, "nothing is read from standard input"},
    {"StandardOutput", {"reconstruct", "cube.json", "-o", "-"}, "nothing is written to standard output"},
    {"OpacityOfNoStructure", {"render", "cube.json", "-o", "a.png", "--opacity", "toth=1"}, "There are: tooth"},
    {"NoSuchSubcommand", {"explain"}, "explain is no subcommand"},
    {"OnlyOptions", {"--quiet"}, "nothing says what to do"},
    {"UnknownMethod", {"reconstruct", "cube.json", "--method", "mc", "-o", "a.glb"}, "db"},
    {"GridWithoutDb", {"reconstruct", "cube.json", "--grid", "64", "-o", "a.glb"}, "--method db"},
    {"TetrahedraOfDb", {"reconstruct", "cube.json", "--method", "db", "-o", "a.glb", "-o", "a.VTU"}, "tetrahedra"},
    {"TrianglesOfDb", {"reconstruct", "cube.json", "--method", "db", "--triangles", "9", "-o", "a.glb"}, "--decimate"},
    {"LinksOfDb",
     {"reconstruct", "cube.json", "--method", "db", "--correspondence", "medial", "-o", "a.glb"},
     "--split"},
    {"LinkOfDb", {"reconstruct", "cube.json", "--method", "db", "--link", "tooth:0:0-0", "-o", "a.glb"}, "--unlink"},
    {"LinkWithoutSlice", {"reconstruct", "cube.json", "--link", "tooth:0-0", "-o", "a.glb"}, "--link pulp:12:0-1"},
    {"LinkWithoutName", {"reconstruct", "cube.json", "--link", ":0:0-0", "-o", "a.glb"}, "--link pulp:12:0-1"},
    {"LinkWithoutUpper", {"reconstruct", "cube.json", "--link", "tooth:0:0-", "-o", "a.glb"}, "--link pulp:12:0-1"},
    {"UnlinkOfLetters", {"reconstruct", "cube.json", "--unlink", "tooth:a:0-0", "-o", "a.glb"}, "--unlink tooth:a:0-0"},
    {"GridIsNoNumber", {"reconstruct", "cube.json", "--method", "db", "--grid", "64x", "-o", "a.glb"}, "--grid 64x"},
    {"GridTooCoarse", {"reconstruct", "cube.json", "--method", "db", "--grid", "3", "-o", "a.glb"}, "from 4"},
    {"UnknownCases", {"reconstruct", "cube.json", "--method", "db", "--cases", "mc33", "-o", "a.glb"}, "consistent"},
    {"UnknownField", {"reconstruct", "cube.json", "--method", "db", "--field", "udf", "-o", "a.glb"}, "hybrid"},
    {"DecimateToNothing",
     {"reconstruct", "cube.json", "--method", "db", "--decimate", "0", "-o", "a.glb"},
     "--decimate 0"},
    {"CheckNothing", {"check"}, "FILE"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, Usage, ::testing::ValuesIn(mistakes),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace odontoscope::testing_support
