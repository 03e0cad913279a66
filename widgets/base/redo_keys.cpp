// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/redo_keys.h"

#include <QKeyEvent>

namespace teleta::base {

QList<QKeySequence> redoKeys() {
    QList<QKeySequence> keys = QKeySequence::keyBindings(QKeySequence::Redo);
    const QKeySequence other(Qt::CTRL | Qt::Key_Y);
    if (!keys.contains(other))
        keys.append(other);
    return keys;
}

bool isRedo(const QKeyEvent& key) {
    return redoKeys().contains(QKeySequence(key.keyCombination()));
}

} // namespace teleta::base
