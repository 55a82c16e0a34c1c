// DICOMDIR: series by its records, names as discs have them, records that lie, and files that are not there.

#include <sys/stat.h>

#include <algorithm>
#include <string>

#include "tests/volume/ct_folder.h"
#include "tests/volume/dicomdir.h"

namespace odontoscope::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> in_ct{R"(CT\IM0)", R"(CT\IM1)", R"(CT\IM2)", R"(CT\IM3)"};

/// A folder CT with a series of four, and CTB beside it with another of three.
class Dicomdir : public CtFolder {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "CT");
    fs::create_directories(folder_ / "CTB");
    put_series(four_, {}, "CT/IM");
    put_series(
        {"0", "1", "2"}, [](Ct& ct) { ct.series = "7.7"; }, "CTB/IM");
  }
  void put_directory(const DicomDir& directory, const std::string& name = "DICOMDIR") {
    put(folder_ / name, directory.bytes());
  }
  void put_records(const std::vector<DirectorySeries>& series) { put_directory({.records = records_of(series)}); }

  static void expect_remark(const Volume& volume, const std::string& words) {
    ASSERT_EQ(volume.remarks.size(), 1u) << words;
    EXPECT_NE(volume.remarks[0].find(words), std::string::npos) << volume.remarks[0];
  }
};

TEST_F(Dicomdir, AloneSaysWhatIsRead) {
  for (const DicomCoding coding : {DicomCoding::explicit_little, DicomCoding::implicit_little}) {
    for (const bool open : {false, true}) {
      put_directory({.records = records_of({{"1.2.3.4", in_ct}}), .open_items = open, .coding = coding});
      for (const Volume& volume : {read("DICOMDIR"), read()}) {
        expect_whole(volume);
        EXPECT_TRUE(volume.remarks.empty()) << volume.remarks[0];
      }
    }
  }
}

TEST_F(Dicomdir, UnderAnotherNameIsToldByItsClass) {
  put_directory({.records = records_of({{"1.2.3.4", in_ct}})}, "index");
  expect_whole(read("index"));
}

TEST_F(Dicomdir, WithSeveralSeriesListsThemToChooseFrom) {
  put_records({{"1.2.3.4", in_ct}, {"7.7", {R"(CTB\IM0)", R"(CTB\IM1)", R"(CTB\IM2)"}}});
  for (const char* name : {"DICOMDIR", ""}) {
    const std::string words = message(name);
    EXPECT_NE(words.find("1: CT, 4 x 3 pixels of 0.25 x 0.5 mm, 4 slices 2 mm apart"), std::string::npos) << words;
    EXPECT_NE(words.find("2: CT, 4 x 3 pixels of 0.25 x 0.5 mm, 3 slices 1 mm apart"), std::string::npos) << words;
    EXPECT_EQ(cause(name), "several-series");
    expect_whole(read(name, {.series = "1"}));
    EXPECT_EQ(read(name, {.series = "7.7"}).size[2], 3u);
    EXPECT_EQ(cause(name, {.series = "3"}), "no-such-series");
  }
}

TEST_F(Dicomdir, FindsNamesAsDiscsAreSeen) {
  fs::rename(folder_ / "CT", folder_ / "ct");
  fs::rename(folder_ / "ct/IM0", folder_ / "ct/im0");
  fs::rename(folder_ / "ct/IM1", folder_ / "ct/IM1;1");
  fs::rename(folder_ / "ct/IM2", folder_ / "ct/im2.");
  put_directory({.records = records_of({{"1.2.3.4", in_ct}})}, "dicomdir");
  expect_whole(read("dicomdir"));
  expect_whole(read());
}

TEST_F(Dicomdir, LeavesOutWhatWasDeleted) {
  put(folder_ / "CT/IM4", Ct{.z = "38", .number = 4, .instance = 5}.object().file());
  std::vector<std::string> five = in_ct;
  five.push_back(R"(CT\IM4)");
  std::vector<DirectoryRecord> records = records_of({{"1.2.3.4", five}});
  records.back().in_use = false;
  put_directory({.records = records});
  expect_whole(read("DICOMDIR"));
  records.back().in_use = true;
  put_directory({.records = records});
  EXPECT_EQ(read("DICOMDIR").size[2], 5u);
  records[records.size() - 2].next = 0;  // nothing leads to it
  put_directory({.records = records});
  expect_whole(read("DICOMDIR"));
}

TEST_F(Dicomdir, WhoseRecordsGoInCirclesOrAstrayIsReadInOrderAndSaysSo) {
  const std::vector<DirectoryRecord> good = records_of({{"1.2.3.4", in_ct}});
  const auto expect_read = [this](const std::vector<DirectoryRecord>& records, std::size_t first = 1) {
    put_directory({.records = records, .first = first});
    const Volume volume = read("DICOMDIR");
    expect_whole(volume);
    expect_remark(volume, "do not lead to each other");
  };
  for (std::size_t n = 0; n < good.size(); ++n) {
    for (std::size_t to = 1; to <= n + 1; ++to) {
      std::vector<DirectoryRecord> records = good;
      records[n].lower = to;
      expect_read(records);
      records = good;
      records[n].next = to;
      expect_read(records);
    }
    std::vector<DirectoryRecord> records = good;
    records[n].astray = 0xfffffff0u;
    expect_read(records);
    records[n].astray = 7;
    expect_read(records);
  }
  expect_read(good, 0);
}

TEST_F(Dicomdir, LacksAFileOfTheSeriesAndNamesIt) {
  put_records({{"1.2.3.4", in_ct}, {"7.7", {R"(CTB\IM0)", R"(CTB\IM1)", R"(CTB\IM2)"}}});
  fs::remove(folder_ / "CT/IM3");  // the last: what is left is even
  EXPECT_EQ(cause("DICOMDIR", {.series = "1"}), "missing-files");
  EXPECT_NE(message({}, {.series = "1"}).find("1 file that cannot be found: CT/IM3. "), std::string::npos)
      << message({}, {.series = "1"});
  // Of another series it is only said, and the remedy reads what is there.
  expect_remark(read("DICOMDIR", {.series = "2"}), "1 other file that cannot be found: CT/IM3");
  EXPECT_EQ(read("CT/IM0").size[2], 3u);
}

TEST_F(Dicomdir, TakesNothingElseForAFile) {
  for (const char* what : {"folder", "pipe", "text", "empty"}) {
    fs::remove_all(folder_ / "CT/IM3");
    const std::string file = (folder_ / "CT/IM3").string();
    if (what == std::string("folder")) fs::create_directory(file);
    if (what == std::string("pipe")) {
      ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    }
    if (what == std::string("text")) put(file, std::string(300, 't'));
    if (what == std::string("empty")) put(file, "");
    put_records({{"1.2.3.4", in_ct}});
    EXPECT_EQ(cause("DICOMDIR"), "missing-files") << what;
  }
}

TEST_F(Dicomdir, WithNamesThatAreNoneSaysSo) {
  for (const std::string& name : {std::string("CT\\IM\0\\x", 8), std::string("CT\\IM\n3"), std::string(3000, 'A'),
                                  std::string(R"(\\\\)"), std::string(R"(A\A\A\A\A\A\A\A\A\A\A\A\A\A\A\A\A\A)")}) {
    std::vector<std::string> names = in_ct;
    names.push_back(name);
    put_records({{"1.2.3.4", names}});
    EXPECT_EQ(cause("DICOMDIR"), "missing-files");
    EXPECT_LT(message("DICOMDIR").size(), 400u);
  }
}

TEST_F(Dicomdir, MayNameAFileTwiceAndItself) {
  std::vector<std::string> names = in_ct;
  for (const char* more : {R"(CT\IM0)", R"(ct\im0)", "DICOMDIR"}) names.push_back(more);
  put_records({{"1.2.3.4", names}});
  expect_whole(read("DICOMDIR"));
}

TEST_F(Dicomdir, LeadsNowhereOutsideItsFolderUnlessAllowed) {
  fs::create_directories(folder_ / "disc/LINKS");
  fs::create_symlink(folder_ / "CT", folder_ / "disc/CT");
  for (const std::string& name : in_ct) {
    const std::string own = name.substr(3);
    fs::create_symlink(folder_ / ("CT/" + own), folder_ / ("disc/LINKS/" + own));
  }
  const auto with = [](const std::string& before) {
    std::vector<std::string> names;
    for (const std::string& name : in_ct) names.push_back(before + name.substr(3));
    return names;
  };
  const std::string absolute = folder_.path().string() + "/CT/";
  for (const std::string& before :
       {std::string(R"(..\CT\)"), std::string("../CT/"), std::string(R"(LINKS\..\..\CT\)"), absolute,
        std::string(R"(CT\)"), std::string(R"(LINKS\)"), std::string(R"(links\)")}) {
    put_directory({.records = records_of({{"1.2.3.4", with(before)}})}, "disc/DICOMDIR");
    for (const char* name : {"disc/DICOMDIR", "disc"}) {
      EXPECT_EQ(cause(name), "outside-folder") << before;
      expect_whole(read(name, {.allow_outside = true}));
    }
  }
}

TEST_F(Dicomdir, OfAnotherFolderIsPassedOver) {
  fs::remove_all(folder_ / "CTB");
  // None of what it names is there.
  put_records({{"1.2.3.4", {R"(A\B)", R"(A\C)"}}});
  for (const char* name : {"DICOMDIR", ""}) {
    const Volume volume = read(name);
    expect_whole(volume);
    EXPECT_NE(volume.remarks.front().find("none is there (such as A/B, A/C)"), std::string::npos) << volume.remarks[0];
  }
  // Something beside it that it does not name: the folder is what was asked for.
  put_records({{"1.2.3.4", {R"(CT\IM0)", R"(CT\IM1)"}}});
  fs::create_directories(folder_ / "CTB");
  put_series(four_, [](Ct& ct) { ct.series = "5.5"; });
  const Volume volume = read();
  expect_whole(volume);
  expect_remark(volume, "does not name");
  EXPECT_EQ(read("DICOMDIR").size[2], 2u);
}

TEST_F(Dicomdir, ThatIsDamagedIsRefusedAndItsFolderSearched) {
  fs::remove_all(folder_ / "CTB");
  const std::string whole = DicomDir{.records = records_of({{"1.2.3.4", in_ct}})}.bytes();
  put(folder_ / "DICOMDIR", whole.substr(0, whole.size() - 20));
  EXPECT_EQ(cause("DICOMDIR"), "truncated-volume");
  EXPECT_NE(message("DICOMDIR").find("give its folder"), std::string::npos);
  const Volume volume = read();
  expect_whole(volume);
  EXPECT_NE(volume.remarks.front().find("DICOMDIR is damaged"), std::string::npos);
}

}  // namespace
}  // namespace odontoscope::test
