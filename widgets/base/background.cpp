// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/background.h"

#include <QCoreApplication>

namespace teleta::base {

QThreadPool& backgroundPool() {
    static QThreadPool pool;
    // Qt waits for its global pool in the same way: running work must not outlive the objects it uses.
    static const bool waits = [] {
        qAddPostRoutine([] { backgroundPool().waitForDone(); });
        return true;
    }();
    (void)waits;
    return pool;
}

} // namespace teleta::base
