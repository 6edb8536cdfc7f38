// SPDX-License-Identifier: Apache-2.0
#include "gui/window/state_look.hpp"

namespace trocar::gui {

const char* shape_of(RunState state) {
  switch (state) {
    case RunState::unknown:
      return "?";
    case RunState::engaged:
      return "▲";
    case RunState::engaging:
      return "△";
    case RunState::stopped:
      return "■";
    case RunState::holding:
      return "●";
    case RunState::cold:
      return "◇";
    case RunState::ended:
    case RunState::no_run:
      return "○";
  }
  return "";
}

QColor colour_of(RunState state, const Theme& theme) {
  switch (state) {
    case RunState::engaged:
    case RunState::engaging:
      return theme.ok;
    case RunState::stopped:
    case RunState::unknown:
      return theme.danger;
    case RunState::holding:
      return theme.accent;
    case RunState::cold:
    case RunState::ended:
    case RunState::no_run:
      return theme.muted;
  }
  return theme.muted;
}

QColor colour_of(Mode mode, const Theme& theme) {
  switch (mode) {
    case Mode::live:
      return theme.live;
    case Mode::simulated:
      return theme.simulated;
    case Mode::replay:
      return theme.replay;
    case Mode::nothing:
      return theme.muted;
  }
  return theme.muted;
}

Qt::PenStyle border_of(Mode mode) {
  switch (mode) {
    case Mode::live:
      return Qt::SolidLine;
    case Mode::simulated:
      return Qt::DashLine;
    case Mode::replay:
    case Mode::nothing:
      return Qt::DotLine;
  }
  return Qt::DotLine;
}

}  // namespace trocar::gui
