-- SPDX-License-Identifier: Apache-2.0
std = "lua54"
read_globals = { "trocar" }
max_line_length = 120

files["**/*_spec.lua"].read_globals = { "describe", "it", "before_each", "expect" }
