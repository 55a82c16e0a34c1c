#include "engine/viewer/settings.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/picture/image.h"
#include "engine/scene/scene_json.h"
#include "recon/core/atomic_file.h"
#include "recon/core/error.h"
#include "recon/core/read_file.h"

namespace odontoscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_tag = 35;
constexpr const char* format_name = "odontoscope.viewer-settings";
constexpr std::size_t most_bytes = 64 * 1024;
/// Deeper than any settings are, and far from what would overflow the stack.
constexpr int deepest = 8;

/// Sets what makes sense and remembers the first thing that does not.
class Reader {
 public:
  Reader(const Json& object, std::string& complaint) : object_(object), complaint_(complaint) {}

  void read(const char* key, int& value, int low, int high) const {
    double wide = value;
    if (number(key, wide, low, high)) value = static_cast<int>(std::lround(wide));
  }
  void read(const char* key, float& value, float low, float high) const {
    double wide = value;
    if (number(key, wide, low, high)) value = static_cast<float>(wide);
  }
  void read(const char* key, double& value, double low, double high) const { number(key, value, low, high); }
  void read(const char* key, bool& value) const {
    const auto found = object_.find(key);
    if (found == object_.end()) return;
    if (found->is_boolean())
      value = found->get<bool>();
    else
      complain(key, "is neither true nor false");
  }
  template <class Value>
  void read(const char* key, Value& value, std::initializer_list<std::pair<const char*, Value>> words) const {
    const auto found = object_.find(key);
    if (found == object_.end()) return;
    if (found->is_string())
      for (const auto& [word, meaning] : words)
        if (*found == word) return void(value = meaning);
    complain(key, "is none of the words that it may be");
  }
  /// A language's tag, a path.
  void read(const char* key, std::string& text, std::size_t longest, const char* what) const {
    const auto found = object_.find(key);
    if (found == object_.end()) return;
    if (found->is_string() && found->get<std::string>().size() <= longest)
      text = found->get<std::string>();
    else
      complain(key, what);
  }
  void read(const char* key, std::vector<std::string>& files) const {
    const auto found = object_.find(key);
    if (found == object_.end()) return;
    if (!found->is_array()) return void(complain(key, "is no list"));
    for (const Json& file : *found) {
      if (files.size() == most_recent_files)
        return void(complain(key, fmt::format("has more than {} files", most_recent_files)));
      if (!file.is_string() || file.get<std::string>().empty() || file.get<std::string>().size() > most_path_bytes)
        return void(complain(key, "has a file that is none"));
      files.push_back(file.get<std::string>());
    }
  }
  void read(const char* key, std::vector<RememberedLook>& looks) const {
    const auto found = object_.find(key);
    if (found == object_.end()) return;
    if (!found->is_object()) return void(complain(key, "is no object"));
    for (const auto& [structure, json] : found->items()) {
      if (looks.size() == most_remembered_looks)
        return void(complain(key, fmt::format("has more than {} structures", most_remembered_looks)));
      if (structure.empty() || structure.size() > most_structure_bytes || !json.is_object())
        return void(complain(key, "has a structure that is none"));
      RememberedLook look{structure, {}, 1};
      const auto colour = json.find("colour");
      try {
        if (colour == json.end() || !colour->is_string())
          return void(complain(key, "has a structure without a colour"));
        look.colour = colour_from_hex(colour->template get<std::string>());
      } catch (const UsageError&) {
        return void(complain(key, "has a colour that is none"));
      }
      if (!json.contains("opacity") || !Reader(json, complaint_).number("opacity", look.opacity))
        return void(complain(key, "has an opacity that is none"));
      looks.push_back(std::move(look));
    }
  }
  Reader inside(const char* key) const {
    static const Json empty = Json::object();
    const auto found = object_.find(key);
    if (found == object_.end()) return {empty, complaint_};
    if (found->is_object()) return {*found, complaint_};
    complain(key, "is no object");
    return {empty, complaint_};
  }

 private:
  bool number(const char* key, float& opacity) const {
    double wide = 1;
    if (!number(key, wide, 0, 1)) return false;
    opacity = static_cast<float>(wide);
    return true;
  }
  bool number(const char* key, double& value, double low, double high) const {
    const auto found = object_.find(key);
    if (found == object_.end()) return false;
    if (!found->is_number()) return complain(key, "is no number");
    const double wanted = found->get<double>();
    if (!(wanted >= low && wanted <= high)) return complain(key, fmt::format("is not between {} and {}", low, high));
    value = wanted;
    return true;
  }
  bool complain(const char* key, std::string_view wrong) const {
    if (complaint_.empty()) complaint_ = fmt::format("\"{}\" {}", key, wrong);
    return false;
  }

  const Json& object_;
  std::string& complaint_;
};

constexpr std::initializer_list<std::pair<const char*, BackFaces>> back_faces_words = {
    {"cull", BackFaces::cull}, {"show", BackFaces::show}, {"tint", BackFaces::tint}};
constexpr std::initializer_list<std::pair<const char*, Camera::Projection>> projection_words = {
    {"perspective", Camera::Projection::perspective}, {"parallel", Camera::Projection::parallel}};
constexpr std::initializer_list<std::pair<const char*, Backdrop>> backdrop_words = {
    {"dark", Backdrop::dark}, {"light", Backdrop::light}, {"white", Backdrop::white}};

template <class Value>
const char* word_for(Value value, std::initializer_list<std::pair<const char*, Value>> words) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return word;
  return "";
}

/// What is written is what is read again: both keep to these. A window is as narrow as its user and the desktop like.
constexpr int smallest_window_side = 64, largest_window_side = 16384, least_picture_side = 16, most_samples_a_side = 4;
constexpr float smallest_text_scale = 0.7f, largest_text_scale = 2.5f;
constexpr double narrowest_view_deg = 40, widest_view_deg = 110, slowest_limit = 0.5, fastest_limit = 24;

/// NaN becomes the least.
template <class Number>
void keep_within(Number& value, Number least, Number most) {
  value = value >= least ? std::min(value, most) : least;
}

Settings within_limits(Settings settings) {
  keep_within(settings.window.width, smallest_window_side, largest_window_side);
  keep_within(settings.window.height, smallest_window_side, largest_window_side);
  keep_within(settings.text_scale, smallest_text_scale, largest_text_scale);
  keep_within(settings.picture.width, least_picture_side, most_picture_side);
  keep_within(settings.picture.height, least_picture_side, most_picture_side);
  keep_within(settings.picture.side, 1, most_samples_a_side);
  keep_within(settings.comfort.field_of_view_deg, narrowest_view_deg, widest_view_deg);
  keep_within(settings.comfort.speed_limit, slowest_limit, fastest_limit);
  for (RememberedLook& look : settings.looks) keep_within(look.opacity, 0.0f, 1.0f);
  return settings;
}

Json parsed(const std::string& text) {
  const Json::parser_callback_t shallow = [](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest) throw std::length_error("too deep");
    return true;
  };
  try {
    return Json::parse(text, shallow);
  } catch (const std::exception&) {
    return Json(nlohmann::detail::value_t::discarded);
  }
}

}  // namespace

void remember_file(Settings& settings, const std::string& file) {
  std::error_code error;
  const std::string whole = std::filesystem::absolute(file, error).lexically_normal().string();
  if (error || whole.empty() || whole.size() > most_path_bytes) return;
  std::erase(settings.recent, whole);
  settings.recent.insert(settings.recent.begin(), whole);
  if (settings.recent.size() > most_recent_files) settings.recent.resize(most_recent_files);
}

Background background_of(Backdrop backdrop) {
  switch (backdrop) {
    case Backdrop::light:
      return {};
    case Backdrop::white:
      return {Background::Kind::plain, {1, 1, 1}, {1, 1, 1}};
    case Backdrop::dark:
      break;
  }
  return {Background::Kind::gradient, colour_of(0x3d4854), colour_of(0x14181c)};
}

void remember(Settings& settings, const Look& look) {
  if (look.structure.empty() || look.structure.size() > most_structure_bytes) return;
  forget(settings, look.structure);
  settings.looks.push_back({look.structure, look.colour, look.opacity});
  if (settings.looks.size() > most_remembered_looks) settings.looks.erase(settings.looks.begin());
}

void forget(Settings& settings, const std::string& structure) {
  std::erase_if(settings.looks, [&](const RememberedLook& known) { return known.structure == structure; });
}

void apply_remembered(const Settings& settings, Scene& scene) {
  for (const RememberedLook& known : settings.looks)
    if (Look* look = scene.look_of(known.structure)) {
      look->colour = known.colour;
      look->opacity = known.opacity;
    }
}

std::string to_json(const Settings& wanted) {
  const Settings settings = within_limits(wanted);
  Json json{{"format", format_name},
            {"window", {{"width", settings.window.width}, {"height", settings.window.height}}},
            {"panel", settings.panel},
            {"names", settings.names},
            {"hints", settings.hints},
            {"desktop_dialogs", settings.desktop_dialogs},
            {"text_scale", std::stod(fmt::format("{}", settings.text_scale))},
            {"back_faces", word_for(settings.back_faces, back_faces_words)},
            {"projection", word_for(settings.projection, projection_words)},
            {"backdrop", word_for(settings.backdrop, backdrop_words)},
            {"picture",
             {{"width", settings.picture.width},
              {"height", settings.picture.height},
              {"as_seen", settings.picture.as_seen},
              {"samples_a_side", settings.picture.side},
              {"transparent", settings.picture.transparent}}},
            {"flight",
             {{"field_of_view_deg", settings.comfort.field_of_view_deg},
              {"speed_limit", settings.comfort.speed_limit},
              {"vignette", settings.comfort.vignette},
              {"reduced_motion", settings.comfort.reduced_motion},
              {"wall_depth", settings.comfort.wall_depth},
              {"wall_thickness", settings.comfort.wall_thickness}}}};
  Json looks = Json::object();
  for (const RememberedLook& look : settings.looks)
    looks[look.structure] = {{"colour", hex(look.colour)}, {"opacity", std::stod(fmt::format("{}", look.opacity))}};
  json["looks"] = looks;
  json["recent"] = settings.recent;
  if (!settings.save_folder.empty()) json["save_folder"] = settings.save_folder;
  if (!settings.language.empty()) json["language"] = settings.language;
  // Names come from files of all kinds: what is no text is replaced, and so forgotten.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReadSettings settings_from_json(const std::string& text) {
  ReadSettings read;
  if (text.size() > most_bytes) return {{}, "it is larger than settings can be"};
  const Json json = parsed(text);
  if (!json.is_object() || !json.contains("format") || json["format"] != format_name)
    return {{}, "it is no settings file of this viewer"};
  const Reader reader(json, read.complaint);
  Settings& settings = read.settings;
  const Reader window = reader.inside("window");
  window.read("width", settings.window.width, smallest_window_side, largest_window_side);
  window.read("height", settings.window.height, smallest_window_side, largest_window_side);
  reader.read("panel", settings.panel);
  reader.read("names", settings.names);
  reader.read("hints", settings.hints);
  reader.read("desktop_dialogs", settings.desktop_dialogs);
  reader.read("save_folder", settings.save_folder, most_path_bytes, "is no folder");
  reader.read("recent", settings.recent);
  reader.read("language", settings.language, longest_tag, "is no language");
  reader.read("text_scale", settings.text_scale, smallest_text_scale, largest_text_scale);
  reader.read("back_faces", settings.back_faces, back_faces_words);
  reader.read("projection", settings.projection, projection_words);
  reader.read("backdrop", settings.backdrop, backdrop_words);
  const Reader picture = reader.inside("picture");
  picture.read("width", settings.picture.width, least_picture_side, most_picture_side);
  picture.read("height", settings.picture.height, least_picture_side, most_picture_side);
  picture.read("as_seen", settings.picture.as_seen);
  picture.read("samples_a_side", settings.picture.side, 1, most_samples_a_side);
  picture.read("transparent", settings.picture.transparent);
  const Reader flight = reader.inside("flight");
  flight.read("field_of_view_deg", settings.comfort.field_of_view_deg, narrowest_view_deg, widest_view_deg);
  flight.read("speed_limit", settings.comfort.speed_limit, slowest_limit, fastest_limit);
  flight.read("vignette", settings.comfort.vignette);
  flight.read("reduced_motion", settings.comfort.reduced_motion);
  flight.read("wall_depth", settings.comfort.wall_depth);
  flight.read("wall_thickness", settings.comfort.wall_thickness);
  reader.read("looks", settings.looks);
  return read;
}

std::filesystem::path settings_file() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path path = value ? value : "";
    return path.is_absolute() ? path : std::filesystem::path();  // the XDG rule: a relative one counts as not set
  };
  if (const auto config = folder("XDG_CONFIG_HOME"); !config.empty()) return config / "odontoscope" / "viewer.json";
  if (const auto home = folder("HOME"); !home.empty()) return home / ".config" / "odontoscope" / "viewer.json";
  return {};
}

ReadSettings read_settings(const std::filesystem::path& file) {
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error)) return {};
  if (!std::filesystem::is_regular_file(file, error))
    return {{}, fmt::format("The settings are left aside: {} is no ordinary file.", file.string())};
  std::string text;
  try {
    text = read_file(file.string(), most_bytes);
  } catch (const Error& wrong) {
    return {{}, fmt::format("The settings are left aside: {}", wrong.what())};
  }
  ReadSettings read = settings_from_json(text);
  if (!read.complaint.empty())
    read.complaint = fmt::format("{}: {}. What makes no sense is left at its default.", file.string(), read.complaint);
  return read;
}

void write_settings(const Settings& settings, const std::filesystem::path& file) {
  if (file.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error)
    throw FileError(file.parent_path().string(), fmt::format("the folder cannot be made ({})", error.message()),
                    "The settings are not remembered.");
  remove_leftovers(file.parent_path());
  AtomicFile written(file);
  written.write(to_json(settings));
  written.commit();
}

}  // namespace odontoscope
