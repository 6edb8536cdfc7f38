// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "components/devices/hid/attached_devices.hpp"

namespace trocar::cli {

/// Something that running a device depends on: how it is here, and what to do about it.
struct Diagnosis {
  /// A problem keeps something from working; a warning lets it work less well; a note is for those
  /// who want the most of a machine.
  enum class Level { good, note, warning, problem };
  std::string key{};  // "clock_source", for programs
  Level level = Level::good;
  std::string finding{};
  std::string cure{};  // commands for a shell, or what else to do; "" where nothing helps
};

const char* to_string(Diagnosis::Level level);

/// Kernel, clock source, processors, frequency, what real-time threads may take; read from /proc
/// and /sys under `root`.
std::vector<Diagnosis> diagnose_machine(const std::string& root = "");

/// Priority and memory that this process may have, found by trying, and the processors' sleep.
std::vector<Diagnosis> diagnose_rights(const std::string& root = "");

/// Whether the laparoscope's udev rule is there, under `root`, and whether each laparoscope among
/// `attached` can be opened.
std::vector<Diagnosis> diagnose_devices(std::span<const hid::AttachedDevice> attached,
                                        const std::string& root = "");

/// The worst first.
std::string diagnoses_text(std::vector<Diagnosis> diagnoses);
nlohmann::ordered_json diagnoses_json(const std::vector<Diagnosis>& diagnoses);
/// Whether none is a problem.
bool sound(const std::vector<Diagnosis>& diagnoses);

}  // namespace trocar::cli
