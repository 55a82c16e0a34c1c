#pragma once
// The desktop's own dialog for files, shown by a program of the desktop: zenity, or kdialog.
//
// It runs beside the window, which goes on; nothing here waits. Whatever the program does (hang, crash, say nonsense)
// ends with words for the person, and with the owner it ends, too.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace odontoscope {

struct FileQuestion {
  enum class For { opening, folder };
  For what = For::opening;
  std::string title;         // in the person's language
  std::filesystem::path at;  // the folder where it begins; empty: the current one
};

struct FileAnswer {
  std::filesystem::path file;  // is there, by its whole path; empty: the person called it off, or there is trouble
  std::string trouble;         // the program's, in words; empty: none
};

/// The program that this desktop has: kdialog first where KDE runs, zenity elsewhere. ODONTOSCOPE_FILE_DIALOG names
/// another, which takes zenity's words unless its name says kdialog. Empty: none.
std::string desktop_dialog_program();

class DesktopDialog {
 public:
  /// Throws FileError if the program does not start.
  DesktopDialog(const std::string& program, const FileQuestion& question);
  /// Closes it.
  ~DesktopDialog();

  /// Once there is one; at once, and nothing, until then. Not to be asked again afterwards.
  std::optional<FileAnswer> answer();

 private:
  struct Ends;
  std::unique_ptr<Ends> ends_;
};

}  // namespace odontoscope
