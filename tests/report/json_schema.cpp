// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/report/json_schema.h"

#include <algorithm>
#include <set>

namespace s2b::report::testing
{
namespace
{

using Json = nlohmann::json;

class Checker
{
public:
    explicit Checker(const Json& root) : m_root(root) {}

    void check(const Json& value, const Json& schema, const std::string& place)
    {
        static const std::set<std::string> kSilent{"$schema", "$defs", "title", "description", "additionalProperties"};
        for (const auto& [keyword, rule] : schema.items())
        {
            if (!kSilent.count(keyword) && !apply(keyword, value, rule, place))
                fault(place, "the keyword " + keyword + " is not known");
        }
        if (value.is_object() && schema.contains("additionalProperties"))
            checkOthers(value, schema, place);
    }
    std::vector<std::string> faults;

private:
    void fault(const std::string& place, const std::string& what) { faults.push_back(place + ": " + what); }

    static bool hasType(const Json& value, const std::string& type)
    {
        return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
               (type == "string" && value.is_string()) || (type == "number" && value.is_number()) ||
               (type == "integer" && value.is_number_integer()) || (type == "null" && value.is_null());
    }

    bool apply(const std::string& keyword, const Json& value, const Json& rule, const std::string& place)
    {
        if (keyword == "type")
        {
            const Json types = rule.is_array() ? rule : Json::array({rule});
            if (std::none_of(types.begin(), types.end(), [&](const Json& t) { return hasType(value, t); }))
                fault(place, "is no " + rule.dump());
        }
        else if (keyword == "$ref")
            check(value, m_root.at(Json::json_pointer(rule.get<std::string>().substr(1))), place);
        else if (keyword == "required")
        {
            for (const Json& name : rule)
            {
                if (!value.contains(name.get<std::string>()))
                    fault(place, "lacks " + name.dump());
            }
        }
        else if (keyword == "properties")
        {
            for (const auto& [name, schema] : rule.items())
            {
                if (value.contains(name))
                    check(value.at(name), schema, place + "/" + name);
            }
        }
        else if (keyword == "items")
        {
            for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
                check(value[i], rule, place + "/" + std::to_string(i));
        }
        else if (keyword == "enum" || keyword == "const")
        {
            const Json values = keyword == "enum" ? rule : Json::array({rule});
            if (std::find(values.begin(), values.end(), value) == values.end())
                fault(place, value.dump() + " is none of " + rule.dump());
        }
        else if (keyword == "oneOf")
        {
            int fits = 0;
            for (const Json& schema : rule)
            {
                Checker other(m_root);
                other.check(value, schema, place);
                fits += other.faults.empty() ? 1 : 0;
            }
            if (fits != 1)
                fault(place, "fits " + std::to_string(fits) + " of " + std::to_string(rule.size()) + " alternatives");
        }
        else if (keyword == "minimum" || keyword == "exclusiveMinimum")
        {
            if (value.is_number() && (value < rule || (keyword != "minimum" && value == rule)))
                fault(place, value.dump() + " is too small");
        }
        else if (keyword == "minItems" || keyword == "maxItems")
        {
            if (value.is_array() && (keyword == "minItems" ? value.size() < rule : value.size() > rule))
                fault(place, "has " + std::to_string(value.size()) + " items");
        }
        else
            return false;
        return true;
    }

    void checkOthers(const Json& value, const Json& schema, const std::string& place)
    {
        const Json& others = schema.at("additionalProperties");
        for (const auto& [name, member] : value.items())
        {
            if (schema.contains("properties") && schema.at("properties").contains(name))
                continue;
            if (others == Json(false))
                fault(place, "has " + name + ", which is not documented");
            else if (others.is_object())
                check(member, others, place + "/" + name);
        }
    }

    const Json& m_root;
};

}  // namespace

std::vector<std::string> faults(const Json& value, const Json& schema)
{
    Checker checker(schema);
    checker.check(value, schema, "");
    return checker.faults;
}

}  // namespace s2b::report::testing
