// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/input_layout.hpp"

/// @file
/// Layouts of devices that many people have, from their published report formats. Not tried on the
/// devices themselves.

namespace trocar::hid {

/// 3Dconnexion SpaceNavigator, 046d:c626: report 1 translation, 2 rotation, 3 buttons. Full
/// deflection, 350 counts, is 1. Axes as the device has them: x right, y towards the user, z down
/// (by the signs that github.com/JakubAndrysek/PySpaceMouse turns them with). Source: the device's
/// report descriptor and recorded reports, as github.com/AndunHH/spacemouse shows them
/// (SpaceNavigator.md).
InputLayout space_navigator();

/// 3Dconnexion SpaceMouse Wireless by its cable, 256f:c62e: report 1 all six axes, 3 buttons; else
/// as space_navigator(). Source: its report descriptor, same place (SpaceMouseWireless.md).
InputLayout space_mouse_wireless();

/// Sony DualShock 4 by USB, 054c:05c4 and 054c:09cc: report 1. Sticks from -1 (left, up) to 0.992
/// (right, down) with 0 at rest, triggers from 0 to 1, hat 0 north and clockwise to 7, 8 at rest.
/// Source: struct dualshock4_input_report_usb in Linux' drivers/hid/hid-playstation.c.
InputLayout dualshock4();

}  // namespace trocar::hid
