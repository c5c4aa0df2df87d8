#include "tests/support/json_schema.h"

#include <regex>

namespace cuesta::tests {
namespace {

using Json = nlohmann::json;

class Validator {
 public:
  explicit Validator(const Json& root) : root_(root) {}

  void check(const Json& schema, const Json& value, const std::string& where) {
    for (const auto& [keyword, rule] : schema.items()) check_keyword(schema, keyword, rule, value, where);
  }

  std::vector<std::string> faults;

 private:
  void expect(bool holds, const std::string& where, const std::string& what) {
    if (!holds) faults.push_back((where.empty() ? "(root)" : where) + ": " + what);
  }

  static bool has_type(const Json& value, const std::string& type) {
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "array") return value.is_array();
    if (type == "object") return value.is_object();
    return type == "null" && value.is_null();
  }

  void check_keyword(const Json& schema, const std::string& keyword, const Json& rule, const Json& value,
                     const std::string& where) {
    if (keyword == "$schema" || keyword == "$id" || keyword == "$defs" || keyword == "title" ||
        keyword == "description") {
      return;
    }
    if (keyword == "$ref") {
      check(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value, where);
    } else if (keyword == "type") {
      expect(has_type(value, rule), where, "is not of type " + rule.get<std::string>());
    } else if (keyword == "const") {
      expect(value == rule, where, "is not " + rule.dump());
    } else if (keyword == "enum") {
      expect(std::find(rule.begin(), rule.end(), value) != rule.end(), where, "is none of " + rule.dump());
    } else if (keyword == "minimum") {
      expect(!value.is_number() || value.get<double>() >= rule.get<double>(), where,
             "is below " + rule.dump());
    } else if (keyword == "minLength") {
      expect(!value.is_string() || value.get<std::string>().size() >= rule.get<size_t>(), where,
             "is too short");
    } else if (keyword == "pattern") {
      expect(!value.is_string() ||
                 std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())),
             where, "does not match " + rule.dump());
    } else if (keyword == "minItems") {
      expect(!value.is_array() || value.size() >= rule.get<size_t>(), where, "has too few items");
    } else if (keyword == "maxItems") {
      expect(!value.is_array() || value.size() <= rule.get<size_t>(), where, "has too many items");
    } else {
      check_applicator(schema, keyword, rule, value, where);
    }
  }

  /// Keywords that hold schemas of parts.
  void check_applicator(const Json& schema, const std::string& keyword, const Json& rule, const Json& value,
                        const std::string& where) {
    if (keyword == "items") {
      for (size_t k = 0; value.is_array() && k < value.size(); ++k) {
        check(rule, value[k], where + "/" + std::to_string(k));
      }
    } else if (keyword == "required") {
      for (const Json& name : rule)
        expect(!value.is_object() || value.contains(name), where, "lacks " + name.dump());
    } else if (keyword == "properties") {
      for (const auto& [name, part] : rule.items()) {
        if (value.is_object() && value.contains(name)) check(part, value[name], where + "/" + name);
      }
    } else if (keyword == "propertyNames") {
      for (const auto& [name, part] : value.items()) check(rule, Json(name), where + "/" + name);
    } else if (keyword == "additionalProperties") {
      const Json known = schema.value("properties", Json::object());
      for (const auto& [name, part] : value.items()) {
        if (known.contains(name)) continue;
        if (rule.is_boolean())
          expect(rule.get<bool>(), where, "has the unknown key " + name);
        else
          check(rule, part, where + "/" + name);
      }
    } else {
      expect(false, where, "the schema uses the keyword " + keyword + ", which this validator does not know");
    }
  }

  const Json& root_;
};

}  // namespace

std::vector<std::string> schema_faults(const nlohmann::json& schema, const nlohmann::json& value) {
  Validator validator(schema);
  validator.check(schema, value, "");
  return validator.faults;
}

}  // namespace cuesta::tests
