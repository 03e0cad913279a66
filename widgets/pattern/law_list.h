// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/pattern/pattern_document.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QLabel;
class QListWidget;
class QPushButton;

namespace teleta::editor {

/// Where the pattern breaks the laws of the display, each with what to do about it; one edit does it. Looks
/// again when the pattern has rested for a moment. Thread: GUI.
class LawList : public QWidget {
    Q_OBJECT
public:
    /// Patterns longer than this are looked at only when asked to: the checker walks through all of their
    /// time.
    static constexpr double kLongestAtOnce_s = 120.0;

    explicit LawList(PatternDocument* document, QWidget* parent = nullptr);

    [[nodiscard]] const std::vector<pattern::Finding>& findings() const { return m_findings; }
    [[nodiscard]] QListWidget* list() const { return m_list; }
    [[nodiscard]] QPushButton* fixButton() const { return m_fix; }
    [[nodiscard]] QString headline() const;
    /// Looks now.
    void check();

signals:
    /// A finding is chosen: it is here.
    void shown(double begin_s, double end_s);

protected:
    void changeEvent(QEvent* event) override;

private:
    void checkLater();
    void showFindings();
    void takeCurrent();

    PatternDocument* m_document;
    QLabel* m_headline;
    QListWidget* m_list;
    QPushButton* m_fix;
    QPushButton* m_check;
    QTimer m_rest;
    std::vector<pattern::Finding> m_findings;
    bool m_checked = false;
};

} // namespace teleta::editor
