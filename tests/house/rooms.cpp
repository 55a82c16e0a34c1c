#include "tests/house/rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace odontoscope::test {
namespace {

const Room* find(const std::vector<Room>& rooms, const std::string& name) {
  const auto found = std::find_if(rooms.begin(), rooms.end(), [&](const Room& room) { return room.name() == name; });
  return found == rooms.end() ? nullptr : &*found;
}

/// The room that a file's path, from the root of the sources, lies in.
const Room* room_of(const std::vector<Room>& rooms, std::string_view path) {
  const auto found =
      std::find_if(rooms.begin(), rooms.end(), [&](const Room& room) { return path.starts_with(room.folder + "/"); });
  return found == rooms.end() ? nullptr : &*found;
}

/// What stands between the quotes of an include of ours; empty for any other line.
std::string included_path(std::string_view line) {
  const auto begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos || !line.substr(begin).starts_with("#include \"")) return {};
  const auto path = line.substr(begin + 10);
  return std::string(path.substr(0, path.find('"')));
}

void reach(const std::vector<Room>& rooms, const Room& from, std::set<std::string>& reached) {
  for (const std::string& link : from.links) {
    if (!reached.insert(link).second) continue;
    if (const Room* next = find(rooms, link)) reach(rooms, *next, reached);
  }
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<Room> read_rooms(std::string_view text) {
  std::vector<Room> rooms;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) continue;
    std::istringstream links(line.substr(colon + 1));
    rooms.push_back({line.substr(0, colon), {std::istream_iterator<std::string>(links), {}}});
  }
  return rooms;
}

std::map<std::string, std::set<std::string>> reachable(const std::vector<Room>& rooms) {
  std::map<std::string, std::set<std::string>> all;
  for (const Room& room : rooms) reach(rooms, room, all[room.name()]);
  return all;
}

std::vector<std::string> faults_of_links(const std::vector<Room>& rooms) {
  std::vector<std::string> faults;
  std::set<std::string> declared;
  for (const Room& room : rooms) {
    for (const std::string& link : room.links) {
      const Room* linked = find(rooms, link);
      if (linked == nullptr) {
        faults.push_back(fmt::format("{} links {}, which is no room", room.folder, link));
      } else if (!declared.contains(link)) {
        faults.push_back(fmt::format("{} links {}, which comes after it", room.folder, linked->folder));
      } else if (room.folder.starts_with("recon/") && !linked->folder.starts_with("recon/")) {
        faults.push_back(fmt::format("{} links {}, which is the engine's", room.folder, linked->folder));
      }
    }
    declared.insert(room.name());
  }
  return faults;
}

std::vector<std::string> faults_of_includes(const std::vector<Room>& rooms, const Room& room, std::string_view source) {
  std::set<std::string> reached;
  reach(rooms, room, reached);
  std::vector<std::string> faults;
  std::istringstream lines{std::string(source)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string path = included_path(line);
    if (path.empty() || path.starts_with("assets/")) continue;  // constants lie below all rooms
    const Room* from = room_of(rooms, path);
    if (from == &room || (from != nullptr && reached.contains(from->name()))) continue;
    faults.push_back(fmt::format("line {}: {}", number, path));
  }
  return faults;
}

std::vector<std::string> faults_of_tree(const std::vector<Room>& rooms, const std::filesystem::path& root) {
  std::vector<std::string> faults;
  for (const Room& room : rooms) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room.folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".h" && ending != ".cpp") continue;
      for (const std::string& fault : faults_of_includes(rooms, room, text_of(entry.path()))) {
        faults.push_back(fmt::format("{}, {}", std::filesystem::relative(entry.path(), root).string(), fault));
      }
    }
  }
  std::sort(faults.begin(), faults.end());
  return faults;
}

std::string picture_of(const std::vector<Room>& rooms) {
  const auto all = reachable(rooms);
  std::string picture = "flowchart LR\n";
  for (const std::string_view side : {"recon", "engine"}) {
    picture += fmt::format("  subgraph {}\n", side);
    for (const Room& room : rooms) {
      if (room.folder.starts_with(side)) picture += fmt::format("    {}\n", room.name());
    }
    picture += "  end\n";
  }
  for (const Room& room : rooms) {
    for (const std::string& link : room.links) {
      const bool follows = std::any_of(room.links.begin(), room.links.end(), [&](const std::string& other) {
        return other != link && all.contains(other) && all.at(other).contains(link);
      });
      if (!follows) picture += fmt::format("  {} --> {}\n", link, room.name());
    }
  }
  return picture;
}

}  // namespace odontoscope::test
