// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/background.h"

#include <QCoreApplication>

namespace teleta::base {

QThreadPool& backgroundPool() {
    static QThreadPool pool;
    // As Qt waits for its own: what runs may not outlive what it was told of.
    static const bool waits = [] {
        qAddPostRoutine([] { backgroundPool().waitForDone(); });
        return true;
    }();
    (void)waits;
    return pool;
}

} // namespace teleta::base
