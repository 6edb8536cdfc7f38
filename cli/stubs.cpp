// SPDX-License-Identifier: Apache-2.0
#include "cli/stubs.hpp"

#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "cli/available.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/script_options.hpp"

namespace trocar::cli {
namespace {

struct StubOptions {
  std::vector<std::string> scripts;
  std::string folder = ".trocar";
};

/// "" where it cannot be read.
std::string beginning_of(const std::filesystem::path& path) {
  std::string text(stub_header.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  write_output(path.string(), text);
}

std::string language_server_settings(const std::string& folder) {
  const nlohmann::ordered_json settings = {{"runtime.version", "Lua 5.4"},
                                           {"workspace.library", {folder}}};
  return settings.dump(2) + "\n";
}

std::string luacheck_settings(const std::string& folder) {
  return fmt::format(
      "std = \"lua54\"\n"
      "read_globals = {{ \"trocar\" }}\n"
      "exclude_files = {{ {} }}\n"
      "files[\"**/*_spec.lua\"].read_globals = {{ \"describe\", \"it\", \"before_each\", "
      "\"expect\" }}\n",
      nlohmann::json(folder + "/**").dump());
}

void say(const std::string& file, Written written, const std::string& advice = "") {
  print(fmt::format("{}: {}\n", file,
                    written == Written::anew    ? "written"
                    : written == Written::again ? "written anew"
                                                : "there already, and kept" + advice));
}

int write_all(const StubOptions& options) {
  const Registry registry = available_components();
  ScriptNames names;
  try {
    names = names_of(registry, options.scripts);
  } catch (const BrokenGraph& broken) {
    complain(mistakes_text(broken.findings));
    return misused;
  }
  const std::filesystem::path folder = options.folder;
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw CLI::ValidationError("--out",
                               fmt::format("{}: {}", in_quotes(options.folder), failure.message()));
  const auto stub = [&](const char* name, std::string_view text) {
    say((folder / name).string(), write_stub(folder / name, text));
  };
  stub("trocar.lua", language_stub());
  stub("laws.lua", laws_stub());
  stub("specs.lua", specs_stub());
  stub("components.lua", components_stub(registry));
  stub("names.lua", names_stub(names));
  say(".luarc.json", write_settings(".luarc.json", language_server_settings(options.folder)),
      fmt::format(": its \"workspace.library\" needs {}", in_quotes(options.folder)));
  say(".luacheckrc", write_settings(".luacheckrc", luacheck_settings(options.folder)));
  return success;
}

}  // namespace

Written write_stub(const std::filesystem::path& path, std::string_view text) {
  const bool there = std::filesystem::exists(path);
  if (there && beginning_of(path) != stub_header)
    throw std::runtime_error(fmt::format(
        "{} is there and not of trocar stubs: move it, or choose another --out", path.string()));
  write_file(path, text);
  return there ? Written::again : Written::anew;
}

Written write_settings(const std::filesystem::path& path, std::string_view text) {
  if (std::filesystem::exists(path)) return Written::kept;
  write_file(path, text);
  return Written::anew;
}

void add_stubs(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "stubs", "Write definitions with which an editor completes and checks scripts");
  const auto options = std::make_shared<StubOptions>();
  command
      ->add_option("script", options->scripts,
                   "Scripts whose signals and parameters are to complete")
      ->type_name("FILE.lua");
  command->add_option("--out", options->folder, "Folder of the definitions (default: .trocar)")
      ->check(check_file_name)
      ->type_name("FILE");
  command->footer(
      "Example:\n  trocar stubs wall.lua\n"
      "For the Lua language server (LuaCATS), whose settings .luarc.json and those of luacheck,\n"
      ".luacheckrc, are written to the current folder where there are none. Scripts are read up\n"
      "to their first trocar.run. Call it again when they change.");
  command->callback([options, &status] { status = write_all(*options); });
}

}  // namespace trocar::cli
