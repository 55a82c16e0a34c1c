#pragma once
// Colours in our JSON files.

#include <string>
#include <string_view>

#include "engine/scene/colour.h"
#include "recon/input/json_schema.h"

namespace odontoscope {

/// "#rrggbb"; anything else is a bad-value. `where` as in json_schema.h.
template <class Where>
JsonField json_colour(JsonSchema& schema, std::string_view key, Where where) {
  return schema.field(key, JsonNode::Shape::text, {.text = [&schema, key, where](const std::string& value) {
                        try {
                          where() = colour_from_hex(value);
                        } catch (const UsageError& error) {
                          schema.fault("bad-value", "\"" + std::string(key) + "\": " + error.wrong(), error.remedy());
                        }
                      }});
}

}  // namespace odontoscope
