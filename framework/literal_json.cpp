// SPDX-License-Identifier: Apache-2.0
#include "framework/literal_json.hpp"

#include <nlohmann/json.hpp>

namespace trocar {
namespace {

using Json = nlohmann::ordered_json;

struct ToJson {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(bool b) const { return b; }
  Json operator()(double d) const { return d; }
  Json operator()(const std::string& s) const { return s; }
  Json operator()(const Literal::List& list) const {
    Json array = Json::array();
    for (const Literal& part : list) array.push_back(std::visit(*this, part.value));
    return array;
  }
  Json operator()(const Literal::Table& table) const {
    Json object = Json::object();
    for (const auto& [key, part] : table) object[key] = std::visit(*this, part.value);
    return object;
  }
};

}  // namespace

std::string literal_json(const Literal& literal) {
  return std::visit(ToJson{}, literal.value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trocar
