// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/icons.h"

#include <QString>
#include <QWidget>

class QLabel;
class QHBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace teleta::chrome {

/// Shown by a view without content: a picture, a sentence, and buttons for the next step. Thread: GUI.
class EmptyState : public QWidget {
    Q_OBJECT

public:
    EmptyState(base::Icon icon, QWidget* parent = nullptr);

    void setTexts(const QString& headline, const QString& sentence);
    /// The first action is the default one.
    QPushButton* addAction(const QString& text, const QString& toolTip);
    /// Sets the text of the action whose button has that object name.
    void setAction(const char* name, const QString& text, const QString& toolTip);
    /// Further choices below the actions, at their preferred size where it fits.
    void setMore(QWidget* more);

private:
    void restyle();

    base::Icon m_icon;
    QLabel* m_picture;
    QLabel* m_headline;
    QLabel* m_sentence;
    QHBoxLayout* m_buttons;
    QVBoxLayout* m_layout;
    bool m_hasDefault = false;
};

} // namespace teleta::chrome
