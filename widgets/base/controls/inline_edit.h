// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace teleta::base {

/// A line that opens over a number in a picture, to type another one. Return or a click elsewhere commits
/// what was changed, Escape takes it back; either way it closes and deletes itself, and the parent gets the
/// focus. Thread: GUI.
class InlineEdit : public QLineEdit {
    Q_OBJECT
public:
    /// Opens with the text selected, at the place in the parent, moved so that it lies inside.
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
