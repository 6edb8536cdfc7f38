// SPDX-License-Identifier: Apache-2.0
// Writes a flowchart whose only box is called by everything that Mermaid could misread, and that
// text: make_odd_picture FOLDER
#include <cstdio>
#include <fstream>
#include <string>

#include "framework/graph_mermaid.hpp"
#include "tests/support/odd_picture.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: make_odd_picture FOLDER\n", stderr), 2;
  const std::string stem = std::string(argv[1]) + "/odd";
  std::ofstream(stem + ".txt") << trocar::test::odd_text;
  std::ofstream(stem + ".mmd") << trocar::graph_mermaid(trocar::test::odd_picture());
  return 0;
}
