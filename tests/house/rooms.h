// The rooms of the house as the build declares them, and what of the sources does not keep to that.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace odontoscope::test {

struct Room {
  std::string folder;              ///< "recon/mesh"
  std::vector<std::string> links;  ///< names of the rooms that it links, as declared: "core"

  [[nodiscard]] std::string name() const { return folder.substr(folder.rfind('/') + 1); }
};

/// Rooms from lines "recon/mesh: core input"; in the order in which the build meets them.
std::vector<Room> read_rooms(std::string_view text);

/// All rooms that each room may include from: those that it links, and theirs. Itself is not among them unless the
/// links run in a circle.
std::map<std::string, std::set<std::string>> reachable(const std::vector<Room>& rooms);

/// What is wrong with the declared links alone: unknown names, a room linked before it is declared, recon linking
/// engine.
std::vector<std::string> faults_of_links(const std::vector<Room>& rooms);

/// Includes of one file, which stands in `room`, of rooms that the room does not reach: "line 7: engine/gpu/gl.h".
std::vector<std::string> faults_of_includes(const std::vector<Room>& rooms, const Room& room, std::string_view source);

/// The same of every .h and .cpp of every room below `root`, each with its file's name before it.
std::vector<std::string> faults_of_tree(const std::vector<Room>& rooms, const std::filesystem::path& root);

/// The rooms as a Mermaid graph, without the arrows that follow from others.
std::string picture_of(const std::vector<Room>& rooms);

}  // namespace odontoscope::test
