// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/first_steps_keeper.h"

#include "widgets/chrome/start/first_steps.h"

#include <algorithm>

namespace teleta::console {

FirstStepsKeeper::FirstStepsKeeper(chrome::FirstSteps& steps, ConsoleSettings& settings, QObject* parent)
    : QObject(parent)
    , m_steps(steps)
    , m_settings(settings)
    , m_done(settings.firstStepsDone()) {
    m_steps.setDone(m_done);
    const bool all = std::ranges::all_of(chrome::FirstSteps::names(),
                                         [this](const QString& name) { return m_done.contains(name); });
    m_steps.setVisible(settings.showsFirstSteps() && !all);
    connect(&m_steps, &chrome::FirstSteps::hideRequested, this, &FirstStepsKeeper::hide);
}

void FirstStepsKeeper::done(const QString& name) {
    if (m_done.contains(name) || !chrome::FirstSteps::names().contains(name))
        return;
    m_done << name;
    m_settings.setFirstStepsDone(m_done);
    m_steps.setDone(m_done);
}

void FirstStepsKeeper::hide() {
    m_settings.setShowsFirstSteps(false);
    m_steps.hide();
}

} // namespace teleta::console
