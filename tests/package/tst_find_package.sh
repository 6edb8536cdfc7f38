#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What find_package(Trocar) accepts, and what it says when it refuses.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh"
install_trocar
cd "$folder" || exit 1

# configure LINES [ARGUMENT...]: a project of these lines and nothing else. The compiler is looked
# for once: each project is configured in the same folder.
configure() {
  local lines=$1
  shift
  mkdir -p project
  printf '%s\n' "cmake_minimum_required(VERSION 3.25)" "$lines" >project/CMakeLists.txt
  "$cmake" -S project -B configured -DCMAKE_PREFIX_PATH="$trocar" "$@"
}
cxx="project(P LANGUAGES CXX)"
alignment="this changes Eigen's alignment, which is 16 bytes in Trocar's libraries"

expect "this version" 0 "found: 1" configure "$cxx
find_package(Trocar ${version%.*} REQUIRED COMPONENTS framework components)
message(\"found: \${Trocar_FOUND}\")"
expect "a newer minor version" 1 'compatible with requested version "0.2"' configure "$cxx
find_package(Trocar 0.2 REQUIRED)"
expect "a newer major version" 1 "TrocarConfig.cmake, version: $version" configure "$cxx
find_package(Trocar 1.0 REQUIRED)"
expect "an unknown component" 1 "Trocar $version has no component \"gui\"; it has framework, components." \
  configure "$cxx
find_package(Trocar REQUIRED COMPONENTS framework gui)"
expect "an unknown component that is optional" 0 "found: 1" configure "$cxx
find_package(Trocar OPTIONAL_COMPONENTS gui)
message(\"found: \${Trocar_FOUND}\")"
expect "a package that is not required is only not found" 0 "found: 0" configure "$cxx
find_package(Trocar COMPONENTS gui)
message(\"found: \${Trocar_FOUND}\")"

expect "an old compiler" 1 "The compiler is GNU 11.4.0" configure "$cxx
set(CMAKE_CXX_COMPILER_ID GNU)
set(CMAKE_CXX_COMPILER_VERSION 11.4.0)
find_package(Trocar REQUIRED)"
expect "another compiler" 1 "Trocar needs GNU 12 or newer, or Clang 14 or newer" configure "$cxx
set(CMAKE_CXX_COMPILER_ID NVHPC)
find_package(Trocar REQUIRED)"

last_standard() {
  configure "$cxx
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
find_package(Trocar REQUIRED)
file(WRITE \${CMAKE_SOURCE_DIR}/own.cpp \"\")
add_library(own own.cpp)
target_link_libraries(own PRIVATE Trocar::framework)" >/dev/null &&
    grep -o 'std=[^ ]*' configured/compile_commands.json | tail -n 1
}
expect "a project in C++17 compiles what links Trocar as C++20" 0 "++20" last_standard
expect "a definition of Eigen's" 1 "hold -DEIGEN_DONT_VECTORIZE: $alignment" configure "$cxx
add_compile_definitions(EIGEN_DONT_VECTORIZE)
find_package(Trocar REQUIRED)"

if [ "$(uname -m)" = x86_64 ]; then
expect "a flag that changes the alignment" 1 "hold -mavx2: $alignment" configure "$cxx
set(CMAKE_CXX_FLAGS \"-O2 -mavx2 -Wall\")
find_package(Trocar REQUIRED)"
expect "one of the configuration" 1 "hold -march=haswell: $alignment" configure "$cxx
set(CMAKE_BUILD_TYPE Release)
set(CMAKE_CXX_FLAGS_RELEASE \"-O3 -march=haswell\")
find_package(Trocar REQUIRED)"
expect "one of the folder" 1 "hold -march=haswell: $alignment" configure "$cxx
add_compile_options(\"\$<\$<CONFIG:Debug>:-Og>\" -march=haswell)
find_package(Trocar REQUIRED)"
expect "a definition that is not the cure" 1 "hold -DEIGEN_MAX_ALIGN_BYTES=32 -mavx: $alignment" configure "$cxx
set(CMAKE_CXX_FLAGS \"-DEIGEN_MAX_ALIGN_BYTES=32 -mavx\")
find_package(Trocar REQUIRED)"
expect "a processor that leaves the alignment alone" 0 "done" configure "$cxx
set(CMAKE_CXX_FLAGS \"-march=x86-64-v2\")
find_package(Trocar REQUIRED)"
expect "the cure" 0 "done" configure "$cxx
set(CMAKE_CXX_FLAGS \"-march=haswell -DEIGEN_MAX_ALIGN_BYTES=16\")
find_package(Trocar REQUIRED)"
fi

# Last, since it needs a folder where no compiler for C++ is known.
rm -r configured
expect "a project without C++" 1 "Trocar is C++: name CXX among the languages" configure "project(P LANGUAGES C)
find_package(Trocar REQUIRED)"
finish
