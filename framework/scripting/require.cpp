// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <sstream>

#include "framework/scripting/script_context.hpp"

namespace trocar::lua {
namespace {

/// A searcher of require(): files beside the script. What it finds belongs to the log.
int find_beside(lua_State* state) {
  std::string name = luaL_checkstring(state, 1);
  std::replace(name.begin(), name.end(), '.', '/');
  name += ".lua";
  const std::string path = (context(state).folder / name).string();
  const auto text = read_file(path);
  if (!text) {
    lua_pushfstring(state, "no file '%s'", path.c_str());
    return 1;
  }
  const std::string chunk = "@" + path;
  if (luaL_loadbufferx(state, text->data(), text->size(), chunk.c_str(), "t") != LUA_OK)
    return lua_error(state);
  context(state).session.add_script(name, *text);
  lua_pushstring(state, path.c_str());
  return 2;
}

}  // namespace

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file || std::filesystem::is_directory(path)) return std::nullopt;
  return text.str();
}

void open_require(lua_State* state) {
  lua_getglobal(state, "package");
  lua_getfield(state, -1, "searchers");
  lua_pushcfunction(state, guarded<find_beside>);
  lua_rawseti(state, -2, 2);
  for (lua_Integer i = luaL_len(state, -1); i > 2; --i) {
    lua_pushnil(state);
    lua_rawseti(state, -2, i);
  }
  lua_pop(state, 1);
  for (const char* path : {"path", "cpath"}) {
    lua_pushstring(state, "");
    lua_setfield(state, -2, path);
  }
  lua_pop(state, 1);
}

}  // namespace trocar::lua
