// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/compose.h"
#include "widgets/pattern/document/pattern_document.h"

#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <QWidget>

#include <atomic>
#include <memory>
#include <vector>

namespace teleta::pattern {

/// Lists where the pattern breaks the laws of perception, each with a fix that is one edit. Checks again in
/// the background when the pattern has not changed for a moment. Thread: GUI.
class LawList : public QWidget {
    Q_OBJECT
public:
    explicit LawList(PatternDocument* document, QWidget* parent = nullptr);
    ~LawList() override;

    [[nodiscard]] const std::vector<Finding>& findings() const { return m_findings; }
    /// Whether the findings are up to date with the pattern.
    [[nodiscard]] bool isChecked() const { return m_checkedRevision == m_document->revision(); }
    [[nodiscard]] QListWidget* list() const { return m_list; }
    /// What it needs at most; without a warning that is one line.
    [[nodiscard]] int mostHeight() const { return m_mostHeight; }
    /// Checks now, without waiting for the pattern to rest.
    void check();

signals:
    /// The user has chosen a finding.
    void shown(int finding);
    /// The list has got its first warning or lost its last one, and needs another height.
    void heightChanged();

private:
    void checkLater();
    void showFindings();
    void takeCurrent();
    void keepKeyboard();
    void returnKeyboard();

    PatternDocument* m_document;
    QLabel* m_headline = base::named<QLabel>("headline", this);
    QListWidget* m_list = new QListWidget(this);
    QPushButton* m_fix = base::named<QPushButton>("fix", this);
    QPointer<QWidget> m_keyboard; ///< what had it when it was disabled; null: nothing here
    QTimer m_rest;
    std::vector<Finding> m_findings;
    std::shared_ptr<std::atomic<bool>> m_cancelled; ///< cancels the running check; null: none is running
    quint64 m_checkedRevision;
    int m_mostHeight = QWIDGETSIZE_MAX;
};

} // namespace teleta::pattern
