// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_page.h"
#include "widgets/base/background.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/chrome/message_log.h"
#include "widgets/study/session_panel.h"
#include "widgets/study/study_start.h"

#include <utility>

namespace teleta::console {

void StudyPage::tellWhatWasOpened() {
    if (m_controller.overview()->isReadOnly) {
        m_messages->post({chrome::Message::Severity::information,
                          tr("This study is read-only: nothing can be written here."),
                          tr("Copy its whole folder to continue the study."), QString()});
    } else if (m_controller.foundInterrupted()) {
        const auto show = [this, folder = m_controller.overview()->location.folder,
                           interrupted = m_controller.chosen()] {
            if (!interrupted || !m_controller.overview() ||
                m_controller.overview()->location.folder != folder)
                return; // another study is open by now
            m_controller.choose(interrupted->first, interrupted->second);
            bringForward(QStringLiteral("session"));
            m_session->takeKeyboard();
        };
        m_messages->post({chrome::Message::Severity::warning,
                          tr("A session of this study was interrupted."),
                          tr("No answer is lost. Resume it, or choose another one."),
                          QString(),
                          {{tr("Show it"), show}}});
    }
}

void StudyPage::setLast(const QString& folder) {
    if (std::exchange(m_last, folder) == folder || m_controller.overview())
        return;
    m_empty->setLast({});
    if (folder.isEmpty())
        return;
    base::runInBackground(
        this,
        [folder]() -> core::Expected<StudyOverview> {
            TELETA_TRY(const auto store, study::StudyStore::openForReading(folder.toStdString()));
            return overviewOf(store);
        },
        [this, folder](const core::Expected<StudyOverview>& found) {
            if (found && folder == m_last) // one that cannot be read is not offered
                m_empty->setLast(StudyScenes::study(*found));
        });
}

void StudyPage::tellThatNoiseFailed(const core::Error& error) {
    const chrome::Message failure{chrome::Message::Severity::warning, tr("The noise cannot be played."),
                                  tr("Play it from another device, and confirm its level."),
                                  QString::fromStdString(core::describe(error))};
    // Before a session the line beside the button says it.
    if (m_controller.runner().isActive())
        m_messages->post(failure);
    else
        chrome::MessageLog::instance().append(failure);
    refresh();
}

} // namespace teleta::console
