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

/// What a view shows while it has nothing to show: a picture, a sentence, and buttons that do what to do
/// next. Thread: GUI.
class EmptyState : public QWidget {
    Q_OBJECT

public:
    EmptyState(base::Icon icon, QWidget* parent = nullptr);

    void setTexts(const QString& headline, const QString& sentence);
    /// The first action is the default one.
    QPushButton* addAction(const QString& text, const QString& toolTip);
    /// Names the action whose button has that object name.
    void setAction(const char* name, const QString& text, const QString& toolTip);
    /// More to choose from, below the actions: as large as it wants to be where there is room.
    void setMore(QWidget* more);

protected:
    void changeEvent(QEvent* event) override;

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
