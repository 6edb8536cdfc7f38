#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Feeds scripts/dev/checks a file each, and sees what they accept and what they refuse.
set -u
checks=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts/dev/checks" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
git init -q "$folder"
failures=0

# row WHAT CHECK EXPECTED FILE LINE: EXPECTED is "accepts" or a piece of the refusal.
row() {
  local what=$1 check=$2 expected=$3 file=$4 line=$5 said status=0
  mkdir -p "$folder/$(dirname "$file")"
  printf '// first line\n%s\n' "$line" >"$folder/$file"
  said=$("$checks/$check" "$folder" 2>&1) || status=$?
  rm "$folder/$file"
  if [ "$expected" = accepts ]; then
    [ $status = 0 ] && [ -z "$said" ] && echo "PASS: $what" && return
  else
    [ $status = 1 ] && [[ $said == *"$file:2"* ]] && [[ $said == *"$expected"* ]] && echo "PASS: $what" && return
  fi
  echo "FAIL: $what: status $status, said: $said"
  failures=$((failures + 1))
}

row "a component knows the framework"  includes accepts components/a.hpp '#include "framework/types.hpp"'
row "the framework knows no component" includes "framework must not know components" framework/a.hpp '#include "components/a.hpp"'
row "a component knows no command"     includes "components must not know cli" components/a.cpp '#include "cli/run.hpp"'
row "the command line knows no window" includes "cli must not know gui" cli/a.cpp '#include "gui/main.hpp"'
row "a plugin knows components"        includes accepts plugins/example/a.cpp '#include "components/a.hpp"'
row "nobody knows a test"              includes "framework must not know tests" framework/a.cpp '#include "tests/a.hpp"'
row "a test knows everybody"           includes accepts tests/a.cpp '#include "cli/run.hpp"'
row "a path that starts elsewhere"     includes "from the repository's root" framework/sub/a.cpp '#include "a.hpp"'
row "a test's own moc"                 includes accepts tests/tst_a.cpp '#include "tst_a.moc"'
row "spaces hide nothing"              includes "framework must not know components" framework/a.hpp '  #  include   "components/a.hpp"'
row "Lua in the binding"               includes accepts framework/scripting/a.cpp '#include <lua.hpp>'
row "Lua outside of the binding"       includes "belongs in framework/scripting" framework/graph.cpp '#include <lua.h>'
row "Lua under its folder's name"      includes "belongs in framework/scripting" cli/a.cpp '#include <lua5.4/lauxlib.h>'
row "hidapi in a device"               includes accepts components/devices/a.cpp '#include <hidapi.h>'
row "hidapi outside of the devices"    includes "belongs in components/devices" cli/doctor.cpp '#include <hidapi/hidapi.h>'
row "Qt in a test"                     includes accepts tests/tst_a.cpp '#include <QTest>'
row "Qt in the live stream"            includes accepts plugins/foxglove/a.cpp '#include <QtWebSockets/QWebSocket>'
row "Qt in another plugin"             includes "belongs in gui" plugins/example/a.cpp '#include <QObject>'
row "Qt in the framework"              includes "belongs in gui" framework/a.hpp '#include <QString>'
row "a loader beside the loader"       includes "belongs in framework/plugin" framework/run.cpp '#include <dlfcn.h>'
row "an atomic in its place"           includes accepts framework/realtime/seqlock.hpp '#include <atomic>'
row "an atomic in a component"         includes "belongs in framework/realtime" components/a.hpp '#include <atomic>'
row "a thread in the recorder"         includes "belongs in framework/realtime" framework/recording/a.cpp '#include <thread>'
row "a mutex in the window"            includes "belongs in framework/realtime" gui/a.cpp '#include <mutex>'
row "the standard library"             includes accepts framework/a.hpp '#include <vector>'
row "a header beside it"               includes "from the repository's root" tests/a.cpp '#include "ball.hpp"'
row "the same in an outside project"   includes accepts tests/package/ball/main.cpp '#include "ball.hpp"'

row "and in the plugin to be copied"   includes accepts plugins/example/a.cpp '#include "groove.hpp"'
row "which knows no command either"    includes "plugins must not know cli" plugins/example/a.cpp '#include "cli/run.hpp"'

work=wor home=hom registry=registry.npmjs
row "a path of the repository"   places accepts a.md 'see framework/work/a.hpp and /usr/include'
row "a machine's path"           places "name a machine's path" a.md "see /${work}k/trocar"
row "a person's folder"          places "name a machine's path" a.md "see /${home}e/somebody"
row "a registry in a lockfile"   places "name a machine's path" package-lock.json "\"resolved\": \"https://${registry}.org/a\""
row "a lockfile without hosts"   places accepts package-lock.json '"integrity": "sha512-abc"'

mkdir "$folder/code"
printf 'one\n\ntwo\n' >"$folder/code/file.txt"
row "a document shows a file"      snippets accepts a.md $'<!-- file: code/file.txt -->\n```\none\n\ntwo\n```\nthree'
row "a document shows another"     snippets "is not code/file.txt" docs/a.md $'<!-- file: code/file.txt -->\n```\none\n```'
row "a document shows too much"    snippets "is not code/file.txt" a.md $'<!-- file: code/file.txt -->\n```\none\n\ntwo\n\n```'
row "the file is not there"        snippets "is not code/none.txt" a.md $'<!-- file: code/none.txt -->\n```\none\n```'
row "code that names no file"      snippets accepts a.md $'```\nfree\n```'

[ $failures = 0 ]
