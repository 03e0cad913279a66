// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace teleta::base {

/// A line edit that opens over a number in a picture to change it. Return or a click elsewhere commits,
/// Escape cancels; then it closes, deletes itself and returns the focus to its parent. Thread: GUI.
class InlineEdit : public QLineEdit {
    Q_OBJECT
public:
    /// Opens with the text selected, at a place in the parent, moved if necessary to lie inside it.
    InlineEdit(QWidget* parent, const QRect& place, const QString& text);

signals:
    void committed(const QString& text);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void finish(bool commit);

    bool m_done = false;
};

} // namespace teleta::base
