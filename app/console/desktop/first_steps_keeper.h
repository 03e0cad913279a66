// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"

#include <QObject>
#include <QString>

namespace teleta::chrome {
class FirstSteps;
}

namespace teleta::console {

/// Remembers which first steps were done, and whether they are shown: until somebody hides them, and no
/// longer at the start after which all are done. Thread: GUI.
class FirstStepsKeeper : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    FirstStepsKeeper(chrome::FirstSteps& steps, ConsoleSettings& settings, QObject* parent = nullptr);

    /// name: as in FirstSteps::names(); doing a step again changes nothing.
    void done(const QString& name);

private:
    void hide();

    chrome::FirstSteps& m_steps;
    ConsoleSettings& m_settings;
    QStringList m_done;
};

} // namespace teleta::console
