// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace teleta::cost {

struct LadderText {
    Q_DECLARE_TR_FUNCTIONS(CostLadder)
};

} // namespace teleta::cost
