// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/closing_questions.h"

#include "app/console/calibrate/calibrate_page.h"
#include "app/console/patterns/patterns_page.h"
#include "app/console/study/forms/protocol_dialog.h"
#include "app/console/study/study_page.h"

#include <algorithm>
#include <utility>

namespace teleta::console {

namespace {

/// Null: there is none.
ProtocolDialog* changedProtocol(const StudyPage& study) {
    const QList<ProtocolDialog*> forms = study.findChildren<ProtocolDialog*>();
    const auto changed = std::find_if(forms.begin(), forms.end(), [](const ProtocolDialog* form) {
        return form->isVisible() && form->isChanged();
    });
    return changed == forms.end() ? nullptr : *changed;
}

} // namespace

/// The study comes last: its session goes on while the others are asked about.
ClosingQuestions::ClosingQuestions(QWidget& window, PatternsPage& patterns, CalibratePage& calibrate,
                                   StudyPage& study)
    : m_window(window) {
    using GoOn = std::function<void()>;
    m_questions.push_back({QStringLiteral("patterns"), [&patterns] { return !patterns.hasUnsaved(); },
                           [&patterns](GoOn goOn) { patterns.whenSettled(std::move(goOn)); }});
    m_questions.push_back({QStringLiteral("calibrate"), [&calibrate] { return !calibrate.hasUnsaved(); },
                           [&calibrate](GoOn goOn) { calibrate.whenSettled(std::move(goOn)); }});
    m_questions.push_back({QStringLiteral("study"), [&study] { return changedProtocol(study) == nullptr; },
                           [&study](GoOn goOn) {
                               ProtocolDialog* form = changedProtocol(study);
                               form->raise();
                               form->whenSettled(std::move(goOn));
                           }});
    m_questions.push_back({QStringLiteral("study"), [&study] { return study.isSettled(); },
                           [&study](GoOn goOn) { study.whenSettled(std::move(goOn)); }});
}

bool ClosingQuestions::allow() {
    m_isSettled = m_isSettled || std::all_of(m_questions.begin(), m_questions.end(),
                                             [](const Question& question) { return question.isSettled(); });
    if (!m_isSettled)
        ask(0);
    return m_isSettled;
}

void ClosingQuestions::ask(std::size_t next) {
    while (next < m_questions.size() && m_questions[next].isSettled())
        ++next;
    if (next == m_questions.size()) {
        m_isSettled = true;
        m_window.close();
        return;
    }
    emit pageRequested(m_questions[next].page);
    m_questions[next].whenSettled([this, next] { ask(next + 1); });
}

} // namespace teleta::console
