// SPDX-License-Identifier: Apache-2.0
// For the headers that are compiled with it: see tests/CMakeLists.txt.
