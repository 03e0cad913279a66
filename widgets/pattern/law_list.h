// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/pattern/document/pattern_document.h"

#include <QTimer>
#include <QWidget>

#include <atomic>
#include <memory>
#include <vector>

class QLabel;
class QListWidget;
class QPushButton;

namespace teleta::editor {

/// Where the pattern breaks the laws of the display, each with what to do about it; one edit does it. Looks
/// again, on a thread of its own, when the pattern has rested for a moment. Thread: GUI.
class LawList : public QWidget {
    Q_OBJECT
public:
    explicit LawList(PatternDocument* document, QWidget* parent = nullptr);
    ~LawList() override;

    [[nodiscard]] const std::vector<pattern::Finding>& findings() const { return m_findings; }
    /// Whether the findings are those of the pattern as it is now.
    [[nodiscard]] bool isChecked() const { return m_checkedRevision == m_document->revision(); }
    [[nodiscard]] QListWidget* list() const { return m_list; }
    [[nodiscard]] QPushButton* fixButton() const { return m_fix; }
    [[nodiscard]] QString headline() const;
    /// Looks now, without waiting for the pattern to rest; checked() tells the end.
    void check();

signals:
    /// The user has chosen a finding.
    void shown(int finding);
    /// The findings are those of the pattern as it is now.
    void checked();

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
    QTimer m_rest;
    std::vector<pattern::Finding> m_findings;
    std::shared_ptr<std::atomic<bool>> m_cancelled; ///< of the check that is under way; null: none is
    quint64 m_checkedRevision;
};

} // namespace teleta::editor
