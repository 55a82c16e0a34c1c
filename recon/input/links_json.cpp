#include "recon/input/links_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "recon/core/limits.h"
#include "recon/input/strict_json.h"
#include "recon/input/structure_names.h"

// The words of this format stand apart from those of contour stacks.
namespace odontoscope::links_file {
namespace {

constexpr std::string_view format_name = "odontoscope.links";
constexpr int format_version = 1;

enum Node { document, format, version, links, link, structure, slice, lower, upper, connect, note };

using Shape = JsonNode::Shape;
constexpr JsonNode::Key document_keys[] = {
    {"format", format, true}, {"version", version, true}, {"links", links, true}};
constexpr JsonNode::Key link_keys[] = {
    {"structure", structure, false}, {"slice", slice, true},     {"lower", lower, true}, {"upper", upper, true},
    {"connect", connect, true},      {"criterion", note, false}, {"z", note, false}};
constexpr JsonNode nodes[] = {
    {Shape::object, "a links file", -1, document_keys},
    {Shape::text, "\"format\""},
    {Shape::number, "\"version\""},
    {Shape::array, "\"links\"", link},
    {Shape::object, "a link", -1, link_keys},
    {Shape::text, "\"structure\""},
    {Shape::count, "\"slice\""},
    {Shape::count, "\"lower\""},
    {Shape::count, "\"upper\""},
    {Shape::boolean, "\"connect\""},
    {Shape::ignored, "a note"},
};

class LinksReader final : public StrictJson {
 public:
  LinksReader() : StrictJson(nodes) {}

  std::vector<Link> read_links(JsonSource& source) {
    read(source);
    return std::move(links_);
  }

 private:
  void opened(int node) override {
    if (node != link) return;
    if (links_.size() == limits::links) {
      refuse("too-many-links", fmt::format("more than {} links", limits::links), "Leave out those made automatically");
    }
    links_.emplace_back();
  }

  void number(int, double value) override {
    if (value == format_version) return;
    refuse("wrong-version",
           fmt::format("version {} of the format, but this program reads version {}", value, format_version),
           "Write the file anew with a matching program");
  }

  void count(int node, std::uint64_t value) override {
    Link& at_hand = links_.back();
    (node == slice ? at_hand.slice : node == lower ? at_hand.lower : at_hand.upper) = value;
  }

  void text(int node, const std::string& value) override {
    if (node == structure) {
      check_structure_name(value, place());
      links_.back().structure = value;
    } else if (value != format_name) {
      refuse("wrong-format", fmt::format("the format is {}, not \"{}\"", in_quotes(value), format_name),
             "Check that this is the file you mean");
    }
  }

  void boolean(int, bool value) override { links_.back().connect = value; }

  std::vector<Link> links_;
};

}  // namespace
}  // namespace odontoscope::links_file

namespace odontoscope {

std::vector<Link> read_links(const std::string& file) {
  JsonSource source = JsonSource::from_file(file);
  return links_file::LinksReader().read_links(source);
}

std::vector<Link> parse_links(std::string_view bytes, std::string name) {
  JsonSource source = JsonSource::from_bytes(bytes, std::move(name));
  return links_file::LinksReader().read_links(source);
}

std::string links_to_json(const std::vector<ReportedLink>& links) {
  std::string text = fmt::format("{{\"format\":\"{}\",\"version\":{},\"links\":[", links_file::format_name,
                                 links_file::format_version);
  const char* separator = "\n";
  for (const auto& [link, criterion] : links) {
    text += fmt::format("{}{{\"structure\":{},\"slice\":{},\"lower\":{},\"upper\":{},\"connect\":{},\"criterion\":{}}}",
                        separator, nlohmann::json(link.structure).dump(), link.slice, link.lower, link.upper,
                        link.connect, nlohmann::json(criterion).dump());
    separator = ",\n";
  }
  return text + "\n]}\n";
}

}  // namespace odontoscope
