// SPDX-License-Identifier: Apache-2.0
#include "framework/plugin/plugin_loader.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <exception>
#include <set>
#include <string_view>

#include "framework/plugin/plugin.hpp"
#include "framework/plugin/plugin_file.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace {

using Reasons = std::vector<std::string>;

/// Thrown where one reason after the other makes no sense any more.
struct PluginRefusal {
  Reasons reasons;
};

/// What the loader of the system says, without the name of the file before it.
std::string loader_message(const std::string& file) {
  const char* said = dlerror();
  std::string_view text = said == nullptr ? "the system does not say why" : said;
  if (text.starts_with(file + ": ")) text.remove_prefix(file.size() + 2);
  return std::string(text);
}

const Plugin& open_plugin(const std::filesystem::path& path) {
  const std::string file = std::filesystem::absolute(path).string();
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw PluginRefusal{
        {fmt::format("it cannot be loaded: {}: rebuild it against this Trocar, "
                     "with the libraries that it needs in its rpath",
                     loader_message(file))}};
  const auto function = reinterpret_cast<decltype(&trocar_plugin)>(dlsym(library, "trocar_plugin"));
  if (function == nullptr)
    throw PluginRefusal{
        {"it exports no function trocar_plugin: include "
         "framework/plugin/plugin.hpp and define it outside of any namespace"}};
  const Plugin* plugin = function();
  if (plugin == nullptr) throw PluginRefusal{{"its trocar_plugin() returns no plugin"}};
  return *plugin;
}

void check_build(const PluginBuild& build) {
  if (Reasons found = differences(build, framework_build()); !found.empty())
    throw PluginRefusal{std::move(found)};
}

/// A text that was left out may be null.
std::string or_empty(const char* text) {
  return text == nullptr ? "" : text;
}

void check_facts(const Plugin& plugin, const std::filesystem::path& file) {
  Reasons missing;
  if (const std::string name = or_empty(plugin.name); name != file.stem())
    missing.push_back(fmt::format("it calls itself \"{}\": it must be called like its file, \"{}\"",
                                  name, file.stem().string()));
  if (or_empty(plugin.version).empty()) missing.emplace_back("it does not say its version");
  if (or_empty(plugin.licence).empty()) missing.emplace_back("it does not say its licence");
  if (or_empty(plugin.doc).empty()) missing.emplace_back("it does not say in one line what it is");
  if (plugin.register_with == nullptr)
    missing.emplace_back("it registers nothing: give it register_with");
  if (!missing.empty()) throw PluginRefusal{std::move(missing)};
}

/// What it brings, in a registry of its own, so that it is taken as a whole or not at all.
Registry brought_by(const Plugin& plugin) {
  Registry own;
  try {
    plugin.register_with(own);
  } catch (const std::exception& error) {
    throw PluginRefusal{{fmt::format("registering failed: {}", error.what())}};
  } catch (...) {
    throw PluginRefusal{{"registering failed: it threw something that is no std::exception"}};
  }
  return own;
}

const ServiceType* find_service(const Registry& registry, std::string_view name) {
  for (const ServiceType& service : registry.services())
    if (service.name == name) return &service;
  return nullptr;
}

void check_names(const Registry& own, const Registry& registry) {
  Reasons taken;
  const auto add = [&](const char* kind, const std::string& name, const std::string& plugin) {
    taken.push_back(fmt::format("its {} \"{}\" is one of {} already: give it another name", kind,
                                name, plugin.empty() ? "Trocar's own" : "plugin " + plugin));
  };
  for (const ComponentType& type : own.types())
    if (const ComponentType* other = registry.find(type.name))
      add("component", type.name, other->plugin);
  for (const ServiceType& service : own.services())
    if (const ServiceType* other = find_service(registry, service.name))
      add("service", service.name, other->plugin);
  if (!taken.empty()) throw PluginRefusal{std::move(taken)};
}

LoadedPlugin load_plugin(Registry& registry, const std::filesystem::path& file) {
  check_build(build_in_file(file));
  const Plugin& plugin = open_plugin(file);
  check_build(plugin.build);  // what counts; that of the file is only found by its mark
  check_facts(plugin, file);
  const Registry own = brought_by(plugin);
  check_names(own, registry);
  LoadedPlugin loaded{plugin.name, plugin.version, plugin.licence, plugin.doc, file, {}, {}};
  for (ComponentType type : own.types()) {
    type.plugin = loaded.name;
    loaded.components.push_back(type.name);
    registry.add(std::move(type));
  }
  for (ServiceType service : own.services()) {
    service.plugin = loaded.name;
    loaded.services.push_back(service.name);
    registry.add(std::move(service));
  }
  return loaded;
}

}  // namespace

Plugins load_plugins(Registry& registry, const std::vector<PluginFolder>& folders) {
  Plugins plugins;
  std::set<std::string> names;  // of files, as of commands in PATH
  for (const PluginFolder& folder : folders) {
    std::error_code ignored;
    if (!folder.asked_for && !std::filesystem::exists(folder.path, ignored)) continue;
    try {
      for (const std::filesystem::path& file : plugin_files(folder.path)) {
        if (!names.insert(file.stem().string()).second) continue;
        try {
          plugins.loaded.push_back(load_plugin(registry, file));
        } catch (const PluginRefusal& refusal) {
          plugins.refused.push_back({file, refusal.reasons});
        } catch (const std::exception& error) {
          plugins.refused.push_back({file, {error.what()}});
        }
      }
    } catch (const std::exception& error) {
      plugins.refused.push_back({folder.path, {error.what()}});
    }
  }
  return plugins;
}

}  // namespace trocar
