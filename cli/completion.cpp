// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/command_tree.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"

namespace trocar::cli {

void add_completion(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("completion", "Print a script that makes a shell complete this command");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "What the script is for")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer(
      "Example, for this session:\n"
      "  source <(trocar completion bash)\n"
      "An installed Trocar brings the scripts to where the shells look for them.");
  command->callback([&app, shell, &status] {
    const CommandTree tree = command_tree(app);
    print(*shell == "bash"  ? bash_completion(tree)
          : *shell == "zsh" ? zsh_completion(tree)
                            : fish_completion(tree));
    status = success;
  });
}

}  // namespace trocar::cli
