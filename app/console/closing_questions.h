// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <cstddef>
#include <functional>
#include <vector>

class QWidget;

namespace teleta::console {

class CalibratePage;
class PatternsPage;
class StudyPage;

/// What is asked before the window closes: of everything that would be lost without a word, one question
/// after another, each on its page. Thread: GUI; a question does not block.
class ClosingQuestions : public QObject {
    Q_OBJECT

public:
    /// All of them outlive this. window: is closed once everything is answered.
    ClosingQuestions(QWidget& window, PatternsPage& patterns, CalibratePage& calibrate, StudyPage& study);

    /// Whether the window may close now. Where something has to be asked first, this begins to, and closes
    /// the window after the last answer, or never when somebody thinks better of it.
    [[nodiscard]] bool allow();
    /// Nobody is there to answer: nothing is asked any more.
    void waive() { m_isSettled = true; }

signals:
    /// Where what is asked about can be seen.
    void pageRequested(const QString& page);

private:
    struct Question {
        QString page;
        std::function<bool()> isSettled;
        std::function<void(std::function<void()>)> whenSettled; ///< asks; goes on when that was answered
    };

    void ask(std::size_t next);

    QWidget& m_window;
    std::vector<Question> m_questions;
    bool m_isSettled = false;
};

} // namespace teleta::console
