#include "engine/app/view_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include "engine/app/batch_items.h"
#include "engine/app/outputs.h"
#include "engine/picture/png.h"
#include "engine/scene/scene_json.h"
#include "engine/view/offscreen.h"
#include "engine/viewer/compare/compare_mode.h"
#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/core/read_file.h"

namespace odontoscope::app {
namespace {

constexpr std::size_t most_script_bytes = 1u << 20;
/// Of time that is waited for, and of time until the viewer has come to rest, of which nobody sees the frames.
constexpr double beat = 1.0 / 30, rest_beat = 0.25, longest_wait = 600;
constexpr int drag_moves = 4, most_frames_to_settle = 120;

constexpr std::array<std::pair<std::string_view, Key>, 18> named_keys = {{{"left", Key::left},
                                                                          {"right", Key::right},
                                                                          {"up", Key::up},
                                                                          {"down", Key::down},
                                                                          {"home", Key::home},
                                                                          {"end", Key::end},
                                                                          {"page-up", Key::page_up},
                                                                          {"page-down", Key::page_down},
                                                                          {"tab", Key::tab},
                                                                          {"enter", Key::enter},
                                                                          {"escape", Key::escape},
                                                                          {"backspace", Key::backspace},
                                                                          {"delete", Key::remove},
                                                                          {"space", Key::space},
                                                                          {"f1", Key::f1},
                                                                          {"f9", Key::f9},
                                                                          {"f12", Key::f12},
                                                                          {"shift", Key::shift}}};
/// Letters that are keys to text fields and with Ctrl.
constexpr std::array<std::pair<char, Key>, 8> letter_keys = {{{'a', Key::a},
                                                              {'c', Key::c},
                                                              {'o', Key::o},
                                                              {'s', Key::s},
                                                              {'v', Key::v},
                                                              {'x', Key::x},
                                                              {'y', Key::y},
                                                              {'z', Key::z}}};

[[noreturn]] void refuse(const std::string& word, const char* remedy) {
  throw UsageError(fmt::format("--script: \"{}\" is no step", word), remedy);
}

std::vector<double> numbers_in(const std::string& word, std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  const char *at = text.data(), *const end = at + text.size();
  while (at != end) {
    double number = 0;
    const auto [behind, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number) || (behind != end && *behind != ',')) break;
    numbers.push_back(number);
    at = behind == end ? end : behind + 1;
  }
  if (at != end || numbers.size() != count)
    refuse(word, "Write numbers with commas: click:640,360  drag:600,300,700,300  scroll:3  wait:0.5");
  return numbers;
}

Key letter_key(char letter) {
  for (const auto& [known, key] : letter_keys)
    if (known == letter) return key;
  return Key::other;
}

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

/// A key goes down, types its character, and comes up again.
ScriptEvents pressed(Key key, char place, Modifiers with, char32_t character) {
  std::vector<Event> down{KeyChanged{key, true, with, place}};
  if (character != 0) down.push_back(TextTyped{character});
  return {{down, {KeyChanged{key, false, {}, place}}}};
}

/// "x", "?", "enter", "ctrl+s", "shift+tab"; nothing for what is no key.
std::optional<ScriptEvents> key_in(std::string_view word) {
  Modifiers with;
  for (bool more = true; more;) {
    more = false;
    for (const auto& [name, flag] : {std::pair<std::string_view, bool Modifiers::*>{"ctrl+", &Modifiers::control},
                                     {"shift+", &Modifiers::shift},
                                     {"alt+", &Modifiers::alt}})
      if (word.size() > name.size() && word.starts_with(name)) {
        with.*flag = true;
        word.remove_prefix(name.size());
        more = true;
      }
  }
  for (const auto& [name, key] : named_keys)
    if (word == name) return pressed(key, '\0', with, key == Key::space ? U' ' : U'\0');
  if (word.size() != 1 || word[0] <= ' ' || word[0] > '~') return std::nullopt;
  const char c = word[0], small = lower_case(std::string(word))[0], place = is_letter(small) ? small : '\0';
  return pressed(letter_key(small), place, with, with.control || with.alt ? U'\0' : static_cast<char32_t>(c));
}

ScriptEvents dragged(MouseButton button, const std::vector<double>& way) {
  ScriptEvents events{{{MouseMoved{way[0], way[1]}}, {MouseButtonChanged{button, true, {}}}}};
  for (int i = 1; i <= drag_moves; ++i) {
    const double share = static_cast<double>(i) / drag_moves;
    events.moments.push_back({MouseMoved{way[0] + share * (way[2] - way[0]), way[1] + share * (way[3] - way[1])}});
  }
  events.moments.push_back({MouseButtonChanged{button, false, {}}});
  return events;
}

ScriptEvents clicked(MouseButton button, const std::vector<double>& place) {
  return {{{MouseMoved{place[0], place[1]}},
           {MouseButtonChanged{button, true, {}}},
           {MouseButtonChanged{button, false, {}}}}};
}

double seconds_in(const std::string& word, std::string_view text) {
  const double seconds = numbers_in(word, text, 1)[0];
  if (seconds < 0 || seconds > longest_wait) refuse(word, "Wait from 0 to 600 seconds");
  return seconds;
}

ScriptHold held(const std::string& word, std::string_view text) {
  const std::size_t comma = text.find(',');
  const std::string places = lower_case(std::string(text.substr(0, comma)));
  if (comma == text.npos || places.empty() || !std::all_of(places.begin(), places.end(), is_letter))
    refuse(word, "Write letters and seconds: hold:w,1.5");
  return {places, seconds_in(word, text.substr(comma + 1))};
}

ScriptFormat format_in(const std::string& word, std::string_view text) {
  const std::vector<double> told = numbers_in(word, text, 3);
  const double side = std::sqrt(told[2]);
  for (const double pixels : {told[0], told[1]})
    if (pixels < 1 || pixels > most_picture_side || pixels != std::floor(pixels))
      refuse(word, "Write width and height in pixels, up to 16384, and samples: format:1280,960,4");
  if (side < 1 || side > 4 || side != std::floor(side))
    refuse(word, "Samples a pixel are 1, 4, 9 or 16: format:1280,960,4");
  return {{.width = static_cast<int>(told[0]),
           .height = static_cast<int>(told[1]),
           .as_seen = false,
           .side = static_cast<int>(side)}};
}

ScriptStep step_in(const std::string& word) {
  if (auto key = key_in(word)) return *key;
  const std::size_t colon = word.find(':');
  const std::string verb = word.substr(0, colon);
  const std::string_view what = colon == word.npos ? std::string_view() : std::string_view(word).substr(colon + 1);
  if (verb == "click") return clicked(MouseButton::left, numbers_in(word, what, 2));
  if (verb == "right-click") return clicked(MouseButton::right, numbers_in(word, what, 2));
  if (verb == "move") {
    const std::vector<double> place = numbers_in(word, what, 2);
    return ScriptEvents{{{MouseMoved{place[0], place[1]}}}};
  }
  if (verb == "drag") return dragged(MouseButton::left, numbers_in(word, what, 4));
  if (verb == "right-drag") return dragged(MouseButton::right, numbers_in(word, what, 4));
  if (verb == "middle-drag") return dragged(MouseButton::middle, numbers_in(word, what, 4));
  if (verb == "scroll") return ScriptEvents{{{Scrolled{0, numbers_in(word, what, 1)[0], {}}}}};
  if (verb == "wait") return ScriptWait{seconds_in(word, what)};
  if (verb == "hold") return held(word, what);
  if (verb == "format") return format_in(word, what);
  for (const auto& [name, kind] : {std::pair{"shot", ScriptSave::What::window},
                                   {"picture", ScriptSave::What::picture},
                                   {"scene", ScriptSave::What::scene}}) {
    if (verb != name || what.empty()) continue;
    known_ending(std::string(what), {kind == ScriptSave::What::scene ? ".json" : ".png"});
    return ScriptSave{kind, std::string(what)};
  }
  refuse(word,
         "Steps are keys (x, enter, ctrl+s), click:X,Y, right-click:X,Y, move:X,Y, drag:X,Y,X,Y, right-drag:, "
         "middle-drag:, scroll:N, hold:KEYS,SECONDS, wait:SECONDS, "
         "format:WIDTH,HEIGHT,SAMPLES, shot:FILE.png, picture:FILE.png, scene:FILE.json");
}

/// The viewer, frame by frame.
class Performance {
 public:
  Performance(Viewer& viewer, const Gl& gl, PixelSize size, const Progress& progress)
      : viewer_(viewer), gl_(gl), size_(size), progress_(progress), pixels_(gl, {size, {GL_RGBA8}}) {}

  void frame(double seconds) {
    progress_.check();
    viewer_.draw({size_, 1, seconds}, {pixels_.id(), 0, 0, size_});
  }

  /// Until nothing moves, and nothing is awaited. What never rests goes on.
  void settle() {
    for (int left = most_frames_to_settle; left > 0; --left) {
      const bool awaited = viewer_.loading() || viewer_.mode<CompareMode>().working();
      if (awaited)
        ++left, std::this_thread::sleep_for(std::chrono::milliseconds(5));
      else if (viewer_.wait_timeout() >= beat)
        break;
      frame(awaited ? 0 : rest_beat);
    }
    if (viewer_.failure()) std::rethrow_exception(viewer_.failure());
    frame(0);
  }

  void perform(const ScriptEvents& events) {
    for (const std::vector<Event>& moment : events.moments) {
      for (const Event& event : moment) viewer_.handle(event);
      frame(0);
    }
    settle();
  }
  void perform(const ScriptWait& wait) { pass(wait.seconds); }
  void perform(const ScriptHold& hold) {
    for (const char place : hold.places) viewer_.handle(KeyChanged{letter_key(place), true, {}, place});
    pass(hold.seconds);
    for (const char place : hold.places) viewer_.handle(KeyChanged{letter_key(place), false, {}, place});
    settle();
  }
  void perform(const ScriptFormat& format) { viewer_.state().settings.picture = format.settings; }
  void perform(const ScriptSave& save) {
    if (save.what == ScriptSave::What::window)
      saved.push_back({save.file, png_bytes(read_pixels(gl_, pixels_.id(), size_))});
    if (save.what == ScriptSave::What::picture) saved.push_back({save.file, png_bytes(viewer_.picture())});
    if (save.what == ScriptSave::What::scene) saved.push_back({save.file, to_json(viewer_.scene_of_picture())});
  }

  std::vector<FileContent> saved;

 private:
  void pass(double seconds) {
    for (double left = seconds; left > 0; left -= beat) frame(std::min(left, beat));
  }

  Viewer& viewer_;
  const Gl& gl_;
  PixelSize size_;
  const Progress& progress_;
  Framebuffer pixels_;
};

}  // namespace

std::vector<ScriptStep> script_steps(const std::string& text) {
  std::vector<ScriptStep> steps;
  std::istringstream lines(text.starts_with('@') ? read_file(text.substr(1), most_script_bytes) : text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    for (const std::string& word : words_in_line(line, "--script")) steps.push_back(step_in(word));
  }
  if (steps.empty()) throw UsageError("--script: there is no step in it", "For example --script \"s shot:cut.png\"");
  return steps;
}

std::vector<std::string> files_of(const std::vector<ScriptStep>& steps) {
  std::vector<std::string> files;
  for (const ScriptStep& step : steps)
    if (const auto* save = std::get_if<ScriptSave>(&step)) files.push_back(save->file);
  return files;
}

std::vector<FileContent> run_script(const std::vector<ScriptStep>& steps, Viewer& viewer, const Gl& gl, PixelSize size,
                                    const Progress& progress) {
  Performance performance(viewer, gl, size, progress);
  performance.settle();
  for (const ScriptStep& step : steps) {
    if (viewer.state().close) break;
    std::visit([&](const auto& one) { performance.perform(one); }, step);
  }
  return std::move(performance.saved);
}

}  // namespace odontoscope::app
