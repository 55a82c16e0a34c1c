// Files appear whole or not at all, whatever goes wrong.

#include "recon/core/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "recon/core/error.h"
#include "recon/core/read_file.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope {
namespace {

using testing_support::content;
using testing_support::put;
using testing_support::TemporaryFolder;
using Names = std::vector<std::string>;

/// Every write beyond so many bytes of a file fails, as on a full disk, until this goes.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit small = before_;
    small.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(AtomicFile, CommitShowsAllBytesAndNoTemporaryFile) {
  TemporaryFolder folder;
  AtomicFile file(folder / "a.bin");
  file.write("one ");
  file.write(std::string("two\0three", 9));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.bin"));
  file.commit();
  EXPECT_EQ(content(folder / "a.bin"), std::string("one two\0three", 13));
  EXPECT_EQ(folder.names(), Names{"a.bin"});
}

TEST(AtomicFile, WithoutCommitNothingChanges) {
  TemporaryFolder folder;
  put(folder / "a.bin", "before");
  {
    AtomicFile file(folder / "a.bin");
    file.write("after");
    AtomicFile moved(std::move(file));
    moved.write("wards");
  }
  EXPECT_EQ(content(folder / "a.bin"), "before");
  EXPECT_EQ(folder.names(), Names{"a.bin"});
}

TEST(AtomicFile, FullDiskIsAFileErrorAndLeavesTheOldFile) {
  TemporaryFolder folder;
  put(folder / "a.bin", "before");
  FullDisk full(1000);
  EXPECT_THROW(
      {
        AtomicFile file(folder / "a.bin");
        file.write(std::string(5000, 'x'));
        file.commit();
      },
      FileError);
  EXPECT_EQ(content(folder / "a.bin"), "before");
  EXPECT_EQ(folder.names(), Names{"a.bin"});
}

TEST(AtomicFile, TargetsThatCannotBeWrittenAreRefusedAtOnce) {
  TemporaryFolder folder;
  EXPECT_THROW(AtomicFile(folder.path()), FileError);
  EXPECT_THROW(AtomicFile(folder / "missing" / "a.bin"), FileError);
  EXPECT_THROW(AtomicFile("/dev/full"), FileError);
  EXPECT_THROW(AtomicFile(""), FileError);
  EXPECT_THROW(AtomicFile(folder.path() / ""), FileError);
  std::filesystem::create_symlink(folder / "nowhere", folder / "link");
  EXPECT_THROW(AtomicFile(folder / "link"), FileError);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(AtomicFile, KeepsModeAndFollowsLinks) {
  TemporaryFolder folder;
  put(folder / "real", "before");
  ::chmod((folder / "real").c_str(), 0640);
  std::filesystem::create_symlink("real", folder / "link");
  AtomicFile file(folder / "link");
  file.write("after");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(content(folder / "real"), "after");
  EXPECT_EQ(static_cast<unsigned>(std::filesystem::status(folder / "real").permissions()), 0640u);
}

TEST(WriteFiles, AllAreWritten) {
  TemporaryFolder folder;
  put(folder / "b", "before");
  const FileContent files[] = {{folder / "a", "first"}, {folder / "b", "second"}};
  write_files(files);
  EXPECT_EQ(content(folder / "a"), "first");
  EXPECT_EQ(content(folder / "b"), "second");
  EXPECT_EQ(folder.names(), (Names{"a", "b"}));
}

TEST(WriteFiles, OneThatCannotBePreparedStopsAll) {
  TemporaryFolder folder;
  put(folder / "a", "before");
  const FileContent files[] = {{folder / "a", "first"}, {folder / "missing" / "b", "second"}};
  EXPECT_THROW(write_files(files), FileError);
  EXPECT_EQ(content(folder / "a"), "before");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(WriteFiles, AFailedRenamePutsTheOthersBack) {
  TemporaryFolder folder;
  put(folder / "a", "before");
  // The temporary file's own name is short, so that a name that is too long shows only at the rename.
  const FileContent files[] = {
      {folder / "a", "first"}, {folder / "new", "second"}, {folder / std::string(300, 'n'), "third"}};
  EXPECT_THROW(write_files(files), FileError);
  EXPECT_EQ(content(folder / "a"), "before");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(WriteFiles, TheSameTargetTwiceIsAUsageError) {
  TemporaryFolder folder;
  put(folder / "a", "before");
  std::filesystem::create_symlink("a", folder / "link");
  const FileContent files[] = {{folder / "a", "first"}, {folder / "link", "second"}};
  EXPECT_THROW(write_files(files), UsageError);
  EXPECT_EQ(content(folder / "a"), "before");
  EXPECT_EQ(folder.names(), (Names{"a", "link"}));
}

TEST(ReadFile, ReadsBackWhatWasWritten) {
  TemporaryFolder folder;
  const std::string bytes("line\r\n\0\xff", 8);
  put(folder / "a", bytes);
  EXPECT_EQ(read_file((folder / "a").string()), bytes);
  put(folder / "empty", "");
  EXPECT_EQ(read_file((folder / "empty").string()), "");
}

TEST(ReadFile, WhatCannotBeReadIsAFileError) {
  TemporaryFolder folder;
  EXPECT_THROW(read_file((folder / "missing").string()), FileError);
  EXPECT_THROW(read_file(folder.path().string()), FileError);
  EXPECT_THROW(read_file("/dev/zero"), FileError);
}

TEST(ReadFile, SizeIsBounded) {
  TemporaryFolder folder;
  put(folder / "a", std::string(100, 'x'));
  EXPECT_EQ(read_file((folder / "a").string(), 100).size(), 100u);
  try {
    read_file((folder / "a").string(), 99);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.cause(), "file-too-large");
  }
}

}  // namespace
}  // namespace odontoscope
