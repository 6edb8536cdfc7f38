// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// QCustomPlot, whose header needs Qt's keywords; "signals" is a word of ours elsewhere.

#include <QObject>

#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef foreach
