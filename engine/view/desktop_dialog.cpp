#include "engine/view/desktop_dialog.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "engine/picture/other_program.h"
#include "recon/core/error.h"
#include "recon/core/system_processes.h"

namespace odontoscope {

namespace {

constexpr std::size_t longest_answer = 4096;  // a path's most bytes
constexpr int child_says = 1, child_complains = 2;
constexpr int called_off = 1;  // exit code of both programs

bool kde_runs() {
  const char* const desktop = std::getenv("XDG_CURRENT_DESKTOP");
  return desktop != nullptr && std::string_view(desktop).find("KDE") != std::string_view::npos;
}

std::vector<std::string> words_for(const std::string& program, const FileQuestion& question) {
  std::error_code error;
  const std::filesystem::path at = question.at.empty() ? std::filesystem::current_path(error) : question.at;
  const bool folder = question.what == FileQuestion::For::folder;
  if (std::filesystem::path(program).filename().string().find("kdialog") != std::string::npos)
    return {program, "--title", question.title, folder ? "--getexistingdirectory" : "--getopenfilename", at.string()};
  // A folder to begin in ends with a slash.
  std::vector<std::string> words = {program, "--file-selection", "--title=" + question.title,
                                    "--filename=" + (at / "").string()};
  if (folder) words.emplace_back("--directory");
  return words;
}

FileAnswer trouble(std::string words) { return {{}, std::move(words)}; }

/// Of what the program said in one line.
FileAnswer understood(std::string said, const FileQuestion& question) {
  if (said.ends_with('\n')) said.pop_back();
  const auto control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; };
  const std::filesystem::path file(said);
  if (said.empty() || std::any_of(said.begin(), said.end(), control) || !file.is_absolute())
    return trouble("The desktop's dialog named no file.");
  std::error_code error;
  const bool there = question.what == FileQuestion::For::folder ? std::filesystem::is_directory(file, error)
                                                                : std::filesystem::exists(file, error);
  if (!there) return trouble(fmt::format("The desktop's dialog named {}, and there is no such thing.", said));
  return {file, {}};
}

}  // namespace

std::string desktop_dialog_program() {
  const char* const named = std::getenv("ODONTOSCOPE_FILE_DIALOG");
  if (named != nullptr && *named != '\0') return named;
  return kde_runs() ? program_in_path({"kdialog", "zenity"}) : program_in_path({"zenity", "kdialog"});
}

struct DesktopDialog::Ends {
  FileQuestion question;
  system::Connection says = system::connect();
  system::Descriptor complaints = system::nameless_file();
  system::Process program;
  std::string said;
  bool silent = false;  // it has closed its end
};

DesktopDialog::DesktopDialog(const std::string& program, const FileQuestion& question)
    : ends_(std::make_unique<Ends>()) {
  Ends& ends = *ends_;
  ends.question = question;
  const bool ready = ends.says.childs.is_open() && ends.complaints.is_open();
  if (!ready || !ends.program.start(words_for(program, question),
                                    {{&ends.says.childs, child_says}, {&ends.complaints, child_complains}}))
    throw FileError(program, fmt::format("does not start: {}", std::strerror(errno)),
                    "Install zenity or kdialog, or choose from the list here");
  ends.says.childs.close();
}

DesktopDialog::~DesktopDialog() = default;

std::optional<FileAnswer> DesktopDialog::answer() {
  Ends& ends = *ends_;
  const auto ending = ends.program.ended();  // before the last words are read
  std::array<char, longest_answer> piece;
  while (!ends.silent) {
    const std::ptrdiff_t count = system::read_within(ends.says.ours, piece.data(), piece.size(), 0);
    if (count == system::nothing_yet) break;
    ends.silent = count <= 0;
    if (count > 0) ends.said.append(piece.data(), static_cast<std::size_t>(count));
    if (ends.said.size() <= longest_answer) continue;
    if (ends.program.runs()) ends.program.kill();
    return trouble("The desktop's dialog named no file.");
  }
  if (!ending) return std::nullopt;
  if (ending->exit_code == 0) return understood(ends.said, ends.question);
  if (ending->exit_code == called_off && ends.said.empty()) return FileAnswer{};
  const std::string complaint = last_line(system::all_bytes(ends.complaints));
  return trouble(
      fmt::format("The desktop's dialog {}{}{}", ending->in_words(), complaint.empty() ? "." : ": ", complaint));
}

}  // namespace odontoscope
