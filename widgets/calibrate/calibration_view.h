// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/compose.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/controls/elided_label.h"

#include <QLabel>
#include <QString>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QWidget>

#include <functional>
#include <initializer_list>

class QColor;
class QPushButton;

namespace teleta::calibrate {

/// A page that calibrates something: title, tools and state at the top, below them what the derived class
/// adds. Every change can be undone, with the buttons "undo" and "redo" and the usual keys. The page reads
/// and writes no files: it emits requests. Thread: GUI.
class CalibrationView : public QWidget {
    Q_OBJECT
public:
    ~CalibrationView() override;

    /// Whether nothing has changed since the calibration was loaded or saved.
    [[nodiscard]] bool isSaved() const;
    void markSaved();

signals:
    void loadRequested();
    void saveRequested();
    void exportFailed(const QString& message);

protected:
    /// tools: object names of the buttons beside the title; must contain "undo", "redo", "load" and "save",
    /// which are connected here.
    CalibrationView(std::initializer_list<const char*> tools, QWidget* parent);

    /// Layout for the rest of the page.
    [[nodiscard]] QVBoxLayout& page() const { return *m_page; }
    QPushButton* addButton(const char* name, QWidget* parent);
    [[nodiscard]] QPushButton* button(const char* name) const;
    void name(const char* button, const QString& text, const QString& toolTip);
    void enable(const char* button, bool enabled);

    void showTitle(const QString& title);
    /// state: a line under the title, after a word for data that are not live.
    void showState(const QString& state, base::Provenance provenance, const QColor& colour);
    /// Result of the last step; the derived class places this label.
    [[nodiscard]] QLabel* verdict() const { return m_verdict; }

    /// Makes a change that can be undone.
    void change(std::function<void()> redo, std::function<void()> undo);
    /// Call when another calibration is shown: clears the undo history.
    void forgetChanges(bool isSaved = true);
    [[nodiscard]] QUndoStack& changes() const { return *m_changes; }
    virtual void undo() = 0;
    virtual void redo() = 0;
    /// Updates everything; called after every change.
    virtual void refresh() = 0;
    /// Whether there is too little width for the title beside the tools.
    [[nodiscard]] bool isNarrow() const;
    void resizeEvent(QResizeEvent* event) override;

private:
    QUndoStack* m_changes = new QUndoStack(this);
    QVBoxLayout* m_page = new QVBoxLayout(this);
    QBoxLayout* m_top = new QBoxLayout(QBoxLayout::LeftToRight);
    QLabel* m_title = new base::ElidedLabel(this);
    QLabel* m_state = base::named<base::ElidedLabel>("state", this);
    QLabel* m_verdict = base::named<QLabel>("verdict", this);
};

} // namespace teleta::calibrate
