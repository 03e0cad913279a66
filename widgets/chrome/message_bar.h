// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include <chrono>
#include <functional>
#include <vector>

namespace teleta::chrome {

/// A notice for the view that it concerns.
struct Message {
    enum class Severity { information, warning, error };

    Severity severity = Severity::information;
    QString text;    ///< what happened
    QString advice;  ///< what to do
    QString details; ///< shown on demand: file, line, column, expected value

    /// Something that can be done about it at once, as a button. It closes the notice.
    struct Action {
        QString text;
        std::function<void()> run;
    };
    std::vector<Action> actions = {};
};

/// Notices over a corner of a view, newest first: what happened, when, what to do, details on demand. The
/// corner is the one where they cover the fewest controls, see freeCorner(). Information leaves by itself
/// after it has been seen for a while, unless the pointer or the keyboard is on it; warnings and errors stay
/// until they are closed. A repeated notice is counted instead of added; at most three are shown, older ones
/// follow when these are closed. Where each corner has a control or a table, they lie over a picture, see
/// freePicture(). Where there is none, the view gives them a strip at its lower edge as long as there are
/// notices, if it can be made so much lower. Nothing above moves under the
/// mouse, and it never blocks. When the language changes all of them leave, since they are in the old one.
/// All notices are kept in the MessageLog. Thread: GUI.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    static constexpr int kShown = 3;
    static constexpr int kKept = 50;

    explicit MessageBar(QWidget* parent = nullptr);

    void post(const Message& message);
    void clear();
    /// How long information is shown, for tests. Default: 6 s.
    void setShowing(std::chrono::milliseconds time) { m_showing = time; }
    [[nodiscard]] int count() const { return static_cast<int>(m_entries.size()); }
    /// How often the newest message has occurred.
    [[nodiscard]] int repeats() const { return m_entries.empty() ? 0 : m_entries.back().repeats; }

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Entry {
        Message message;
        QDateTime since;
        int repeats = 1;
        bool open = false;
        std::chrono::milliseconds seen{0}; ///< how long it has been shown
    };
    /// Counts the time that notices are seen, and takes away those that leave by themselves.
    void age();
    void rebuild();
    /// Moves it to its place over the view.
    void settle();
    /// Height of the strip that the view's layout leaves free at its lower edge.
    void reserve(int height);
    [[nodiscard]] QWidget* makeRow(std::size_t index);

    QVBoxLayout* m_layout = new QVBoxLayout(this);
    QWidget* m_tabStop = new QWidget(this); ///< precedes the buttons in the tab order
    std::vector<Entry> m_entries;
    std::chrono::milliseconds m_showing{6000};
    QTimer m_age;
    int m_reserved = 0;
};

} // namespace teleta::chrome
