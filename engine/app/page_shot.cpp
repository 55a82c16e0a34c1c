#include "engine/app/page_shot.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "engine/app/piped_process.h"
#include "engine/gpu/graphics_error.h"
#include "engine/picture/other_program.h"
#include "engine/picture/png.h"
#include "recon/core/base64.h"
#include "recon/core/error.h"
#include "recon/core/system_processes.h"

namespace odontoscope::app {
namespace {

using nlohmann::json;
using Clock = PipedProcess::Clock;

const std::vector<std::string> known_browsers{
    "chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge", "brave-browser"};
constexpr std::chrono::seconds farewell{3};

/// No window, no network, no scroll bars, colours as they are.
std::vector<std::string> words_for(const std::string& program, const std::string& profile) {
  std::vector<std::string> words{program,
                                 "--headless",
                                 "--remote-debugging-pipe",
                                 "--user-data-dir=" + profile,
                                 "--no-first-run",
                                 "--no-default-browser-check",
                                 "--disable-extensions",
                                 "--disable-background-networking",
                                 "--disable-component-update",
                                 "--disable-sync",
                                 "--disable-default-apps",
                                 "--disable-quic",
                                 "--hide-scrollbars",
                                 "--force-color-profile=srgb",
                                 "--mute-audio",
                                 "--proxy-server=127.0.0.1:9",
                                 "--proxy-bypass-list=<-loopback>",
                                 "--host-resolver-rules=MAP * ~NOTFOUND"};
  if (system::is_administrator()) words.push_back("--no-sandbox");
  words.push_back("about:blank");
  return words;
}

/// Resolves to the reason of a failure, or to an empty text.
constexpr const char* until_drawn = R"(new Promise(done => {
  const root = document.documentElement;
  const look = () => {
    if (root.hasAttribute('data-failed')) done(root.getAttribute('data-failed') || 'it does not say why');
    else if (root.hasAttribute('data-drawn')) requestAnimationFrame(() => requestAnimationFrame(() => done('')));
  };
  new MutationObserver(look).observe(root, {attributes: true});
  look();
}))";

std::string url_of(const std::string& page) {
  std::string url = "file://";
  for (const char c : std::filesystem::absolute(page).generic_string()) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       std::string_view("/-._~").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

}  // namespace

std::string browser_program(const std::string& asked) {
  if (!asked.empty()) return asked;
  if (const char* const named = std::getenv("ODONTOSCOPE_BROWSER"); named != nullptr && *named != '\0') return named;
  std::string found = program_in_path(known_browsers);
  if (!found.empty()) return found;
  throw GraphicsError("no-browser", "a page is to be shot, and no browser of the Chromium family was found",
                      "Install chromium, or name one by --browser or ODONTOSCOPE_BROWSER.");
}

/// Questions and answers, of the browser or of the page that it has open.
class PageShots::Talk {
 public:
  Talk(const std::string& program, double timeout_s, const Progress& progress)
      : program_(program),
        timeout_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_s))),
        progress_(progress),
        process_(words_for(program, profile_.path())) {}

  ~Talk() {
    if (process_.send(json{{"id", ++last_}, {"method", "Browser.close"}}.dump()))
      process_.wait(Clock::now() + farewell);
  }

  void begin(const std::string& page) {
    page_ = page;
    deadline_ = Clock::now() + timeout_;
    session_.clear();
    loaded_ = false;
  }

  json ask(const std::string& method, const json& words = json::object()) {
    json question{{"id", ++last_}, {"method", method}, {"params", words}};
    if (!session_.empty()) question["sessionId"] = session_;
    if (!process_.send(question.dump())) gone();
    while (true) {
      const json told = next();
      if (!told.contains("id") || told["id"] != last_) continue;
      if (told.contains("error"))
        fail(fmt::format("{} refuses {}: {}", program_, method, told["error"].value("message", "")));
      return told.value("result", json::object());
    }
  }

  void wait_until_loaded() {
    while (!loaded_) next();
  }

  void attach(const std::string& session) { session_ = session; }

  [[noreturn]] void fail(const std::string& why) const {
    Place place;
    place.file = page_;
    throw InputError("cannot-be-shot", place, why, "Open it in the browser, and see what it says");
  }

  const std::string& folder() const { return profile_.path(); }

 private:
  json next() {
    const std::optional<std::string> message = process_.next(deadline_, progress_.stop);
    progress_.check();
    if (!message && Clock::now() >= deadline_)
      fail(fmt::format("it has not said that it has drawn within {:.0f} s (<html data-drawn>)",
                       std::chrono::duration<double>(timeout_).count()));
    if (!message) gone();
    json told = json::parse(*message, nullptr, false);
    if (!told.is_object()) gone();
    loaded_ = loaded_ || told.value("method", "") == "Page.loadEventFired";
    return told;
  }

  [[noreturn]] void gone() const {
    const std::string said = process_.complaint();
    fail(fmt::format("{} ended before it was drawn{}{}", program_, said.empty() ? "" : ": ", said));
  }

  std::string program_, page_, session_;
  Clock::duration timeout_;
  Progress progress_;
  OwnFolder profile_;  // outlives the process
  PipedProcess process_;
  Clock::time_point deadline_ = Clock::now();
  int last_ = 0;
  bool loaded_ = false;
};

PageShots::PageShots(const std::string& program, double timeout_s, const Progress& progress)
    : talk_(std::make_unique<Talk>(program, timeout_s, progress)) {}
PageShots::~PageShots() = default;

Image PageShots::shoot(const std::string& page, int width, int height) {
  Talk& talk = *talk_;
  talk.begin(page);
  const std::string target = talk.ask("Target.createTarget", {{"url", "about:blank"}}).value("targetId", "");
  talk.attach(talk.ask("Target.attachToTarget", {{"targetId", target}, {"flatten", true}}).value("sessionId", ""));
  talk.ask("Page.enable");
  talk.ask("Network.enable");
  talk.ask("Network.emulateNetworkConditions",
           {{"offline", true}, {"latency", 0}, {"downloadThroughput", 0}, {"uploadThroughput", 0}});
  talk.ask("Emulation.setDeviceMetricsOverride",
           {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
  talk.ask("Emulation.setEmulatedMedia", {{"features",
                                           {{{"name", "prefers-color-scheme"}, {"value", "dark"}},
                                            {{"name", "prefers-reduced-motion"}, {"value", "reduce"}}}}});
  const json opened = talk.ask("Page.navigate", {{"url", url_of(page)}});
  if (opened.contains("errorText"))
    talk.fail(fmt::format("it cannot be opened: {}", opened["errorText"].get<std::string>()));
  talk.wait_until_loaded();
  const json drawn =
      talk.ask("Runtime.evaluate", {{"expression", until_drawn}, {"awaitPromise", true}, {"returnByValue", true}});
  const std::string failure = drawn.contains("exceptionDetails")
                                  ? "its script cannot be run"
                                  : drawn.value("/result/value"_json_pointer, "it was left");
  if (!failure.empty()) talk.fail(fmt::format("it says that it cannot be drawn: {}", failure));
  const std::string png =
      from_base64(talk.ask("Page.captureScreenshot", {{"format", "png"}}).value("data", "")).value_or("");
  talk.attach("");
  talk.ask("Target.closeTarget", {{"targetId", target}});
  const std::string file = (std::filesystem::path(talk.folder()) / "shot.png").string();
  std::ofstream(file, std::ios::binary) << png;
  return read_png(file);
}

}  // namespace odontoscope::app
