// Formats as declarations: what goes where, and what is said of the rest.
#include "recon/input/json_schema.h"

#include <gtest/gtest.h>

#include "recon/core/error.h"

namespace odontoscope {
namespace {

enum class Light { warm, cold };
constexpr NameTable<Light, 2> lights{{{"warm", Light::warm}, {"cold", Light::cold}}};

struct Bulb {
  double watts = 5;
  Light light = Light::warm;
};
struct Lamp {
  int sockets = 1;
  std::optional<double> height;
  std::vector<Bulb> bulbs;
  std::vector<std::string> rooms, spares;
  std::string note, named;
};

/// What was read, and the cause or the complaint.
std::pair<Lamp, std::string> read(const std::string& members, JsonReading reading) {
  Lamp lamp;
  JsonSchema schema("a lamp", reading);
  const auto bulb = last(lamp.bulbs);
  schema.document("demo.lamp", {1, 2},
                  {schema.number("sockets", lamp.sockets, {.low = 1, .high = 8, .whole = true}),
                   optional(schema.number("height", lamp.height)),
                   optional(schema.list("bulbs", "a bulb", lamp.bulbs, {.most = 2},
                                        {schema.number("watts", of(bulb, &Bulb::watts)),
                                         optional(schema.word("light", of(bulb, &Bulb::light), lights))})),
                   optional(schema.texts("rooms", "a room", {.least = 1, .most = 2},
                                         [&](const std::string& room) { lamp.rooms.push_back(room); })),
                   optional(schema.map("spares", "a spare", [&](const std::string& name) { lamp.named = name; }, {},
                                       {.closed = [&] { lamp.spares.push_back(lamp.named); }})),
                   optional(schema.kept("note", lamp.note))});
  try {
    schema.read(R"({"format":"demo.lamp","version":2)" + members + "}", "lamp.json");
  } catch (const InputError& error) {
    return {lamp, error.cause()};
  }
  return {lamp, schema.complaint()};
}
std::string cause_of(const std::string& members) { return read(members, JsonReading::strict).second; }

TEST(JsonSchema, PutsValuesWhereTheyBelong) {
  const auto [lamp, cause] = read(
      R"(,"sockets":2,"bulbs":[{"watts":7},{"light":"cold","watts":9}],"height":-0.5,"spares":{"x-ray":{},"b":{}},)"
      R"("note" : { "a" : [ 1, -2, 0.5, 1e3, "\"[", true, null, { } ], "x-b" : "" })",
      JsonReading::strict);
  EXPECT_EQ(cause, "");
  EXPECT_EQ(lamp.sockets, 2);
  EXPECT_EQ(lamp.height, -0.5);
  ASSERT_EQ(lamp.bulbs.size(), 2u);
  EXPECT_EQ(lamp.bulbs[0].watts, 7);
  EXPECT_EQ(lamp.bulbs[1].light, Light::cold);
  EXPECT_EQ(lamp.spares, (std::vector<std::string>{"x-ray", "b"})) << "names are anyone's";
  EXPECT_EQ(lamp.note, R"({"a":[1,-2,0.5,1000.0,"\"[",true,null,{}],"x-b":""})");
  for (const char* kept : {"7", "-7", "0.25", "\"a\"", "null", "true", "[]", "{}"})
    EXPECT_EQ(read(R"(,"sockets":1,"note":)" + std::string(kept), JsonReading::strict).first.note, kept);
}

TEST(JsonSchema, RefusesWhatBreaksTheDeclarations) {
  EXPECT_EQ(cause_of(""), "missing-key");
  EXPECT_EQ(cause_of(R"(,"sockets":0)"), "bad-value");
  EXPECT_EQ(cause_of(R"(,"sockets":1.5)"), "bad-value");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"sockets":1)"), "repeated-key");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"colour":1)"), "unknown-key");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"height":null)"), "wrong-type");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"bulbs":[{"watts":1,"light":"hot"}])"), "bad-value");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"bulbs":[{"watts":1},{"watts":1},{"watts":1}])"), "bad-value");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"rooms":[])"), "bad-value");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"rooms":["a","b","c"])"), "bad-value");
  EXPECT_EQ(cause_of(R"(,"sockets":1,"note":)" + std::string(100, '[')), "too-deep");
  JsonSchema schema("a lamp");
  schema.document("demo.lamp", {1, 1}, {});
  EXPECT_THROW(schema.read(R"({"format":"demo.lamp","version":2})", "lamp.json"), InputError);
}

TEST(JsonSchema, TolerantLetsUnknownNullAndRepeatedPass) {
  const auto [lamp, cause] = read(R"(,"sockets":null,"colour":{"a":[1]},"height":1,"height":2)", JsonReading::tolerant);
  EXPECT_EQ(cause, "");
  EXPECT_EQ(lamp.sockets, 1);
  EXPECT_EQ(lamp.height, 2);
  EXPECT_EQ(read(R"(,"sockets":"two")", JsonReading::tolerant).second, "wrong-type");
  EXPECT_EQ(read(R"(,"bulbs":[null])", JsonReading::tolerant).second, "wrong-type");
}

TEST(JsonSchema, ForgivingLeavesOutAndSaysTheFirst) {
  const auto [lamp, complaint] =
      read(R"(,"sockets":99,"bulbs":7,"height":{"a":[1]},"rooms":["a","b","c"])", JsonReading::forgiving);
  EXPECT_NE(complaint.find("sockets"), std::string::npos) << complaint;
  EXPECT_EQ(lamp.sockets, 1);
  EXPECT_TRUE(lamp.bulbs.empty());
  EXPECT_FALSE(lamp.height);
  EXPECT_EQ(lamp.rooms, (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace odontoscope
