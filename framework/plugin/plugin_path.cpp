// SPDX-License-Identifier: Apache-2.0
#include "framework/plugin/plugin_path.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "framework/text.hpp"

namespace trocar {
namespace {

namespace fs = std::filesystem;

/// The folder of the library that this code is in; "" where the system does not say.
fs::path library_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&library_folder), &info) == 0 ||
      info.dli_fname == nullptr)
    return {};
  std::error_code failure;
  const fs::path file = fs::canonical(info.dli_fname, failure);
  return failure ? fs::path() : file.parent_path();
}

}  // namespace

std::vector<PluginFolder> plugin_folders(std::string_view variable) {
  std::vector<PluginFolder> folders;
  for (const std::string_view folder : split(variable, ':'))
    if (!folder.empty()) folders.push_back({fs::path(folder)});
  if (const fs::path here = library_folder(); !here.empty())
    folders.push_back({here / "trocar" / "plugins", false});
  return folders;
}

std::vector<PluginFolder> plugin_folders() {
  const char* variable = std::getenv("TROCAR_PLUGIN_PATH");
  return plugin_folders(variable == nullptr ? "" : variable);
}

std::vector<fs::path> plugin_files(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> files;
  fs::directory_iterator each(folder, failure);
  for (; !failure && each != fs::directory_iterator(); each.increment(failure))
    if (each->path().extension() == ".so") files.push_back(each->path());
  if (failure) throw std::runtime_error("it cannot be searched: " + failure.message());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace trocar
