#pragma once
// Two folders of pictures, as they should be and as they are: what screenshot tests come down to.

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "engine/picture/image_difference.h"
#include "recon/core/progress.h"

namespace odontoscope {

enum class PictureOutcome {
  alike,       // within the tolerance
  different,   // beyond it, or of another size
  missing,     // expected, and not there
  unexpected,  // there, and not expected
  unreadable,  // one of the files, or its mask, is no PNG that can be read, or the mask is of another size
};
const char* name(PictureOutcome outcome);

struct ComparedPicture {
  std::string name;  // below either folder, with '/'
  PictureOutcome outcome = PictureOutcome::alike;
  ImageDifference difference;                   // of both, if they could be read
  int expected_width = 0, expected_height = 0;  // 0: not there, or not read
  int actual_width = 0, actual_height = 0;
  bool masked = false;
  std::string cause, message;  // of what is unreadable
};

/// What somebody else draws: pictures that are not in a folder yet.
struct PicturesToDraw {
  std::set<std::string> names;  // below the folder, as if they were there: "views/buccal.png"
  /// As large as the picture expected; 0 x 0: there is none. InputError and FileError make it unreadable; all else ends
  /// the comparison.
  std::function<Image(const std::string& name, int width, int height)> draw;
};

struct CompareFoldersOptions {
  ImageTolerance tolerance;
  /// A folder with a mask for each picture that needs one, under the same name; or one PNG for all; or empty. See
  /// `compare`.
  std::string mask;
  /// Besides the PNGs of the folder of actual pictures.
  PicturesToDraw to_draw;
};

/// The pictures of one comparison, for whoever shows them; a picture that is not there is empty.
struct PicturesCompared {
  Image expected, actual, mask;
};

/// The names of all *.png (in any case) of a folder and those below. Throws as compare_folders does.
std::set<std::string> pictures_below(const std::string& folder);

/// All *.png (in any case) in the two folders and those below, by name; links to folders are not followed. `look` is
/// given each that is not alike, with its pictures, in order. Stage "compare". Throws FileError (no folder, or cannot
/// be listed; too many files), InputError for a mask for all that is no PNG, Cancelled.
std::vector<ComparedPicture> compare_folders(
    const std::string& expected, const std::string& actual, const CompareFoldersOptions& options,
    const std::function<void(const ComparedPicture&, const PicturesCompared&)>& look, const Progress& progress = {});

/// The same of two files, which must be readable (throws as read_png does).
ComparedPicture compare_files(const std::string& expected, const std::string& actual,
                              const CompareFoldersOptions& options,
                              const std::function<void(const ComparedPicture&, const PicturesCompared&)>& look);

}  // namespace odontoscope
