// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <QWidget>

#include <vector>

class QVBoxLayout;

namespace teleta::chrome {

/// A notice at the top of the view that it concerns.
struct Message {
    enum class Severity { information, warning, error };

    Severity severity = Severity::information;
    QString text;    ///< what happened
    QString advice;  ///< what to do
    QString details; ///< shown on demand: file, line, column, expected
};

/// Notices at the top of a view, newest first: what happened, since when, what to do, details on demand. One
/// that repeats counts up instead of filling the view; at most three are shown, older ones wait behind them.
/// They lie over the upper right corner of the part of the view that is seen, and claim no room in a layout
/// that they are put into: nothing moves away under the mouse. Nothing blocks. All of them are kept in the
/// MessageLog. Thread: GUI.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    static constexpr int kShown = 3;
    static constexpr int kKept = 50;

    explicit MessageBar(QWidget* parent = nullptr);

    void post(const Message& message);
    void clear();
    [[nodiscard]] int count() const { return static_cast<int>(m_entries.size()); }
    /// How often the newest message came.
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
    };
    void rebuild();
    /// To where it belongs over the view.
    void settle();
    [[nodiscard]] QWidget* makeRow(std::size_t index);

    QVBoxLayout* m_layout;
    QWidget* m_tabStop; ///< behind it in the chain of Tab come the buttons
    std::vector<Entry> m_entries;
};

} // namespace teleta::chrome
