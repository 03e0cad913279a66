// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QString>
#include <QVBoxLayout>
#include <QWidget>

class QPushButton;

namespace teleta::chrome {

/// Shown by a view without content: a picture, a sentence, and buttons for the next step. The picture goes
/// where there is no room for it. Thread: GUI.
class EmptyState : public QWidget {
    Q_OBJECT

public:
    EmptyState(base::Icon icon, QWidget* parent = nullptr);

    /// Leaves out headline and sentence, where what is below needs the room.
    void setBrief(bool brief);
    /// The height at which nothing is smaller than it likes to be, without the picture.
    [[nodiscard]] int neededHeight(bool brief) const;
    void setTexts(const QString& headline, const QString& sentence);
    /// The first action is the default one.
    QPushButton* addAction(const QString& text, const QString& toolTip);
    /// Sets the text of the action whose button has that object name.
    void setAction(const char* name, const QString& text, const QString& toolTip);
    /// Further choices below the actions, at their preferred size where it fits.
    void setMore(QWidget* more);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void restyle();

    base::Icon m_icon;
    QLabel* m_picture = new QLabel(this);
    QLabel* m_headline = new QLabel(this);
    QLabel* m_sentence = new QLabel(this);
    QHBoxLayout* m_buttons = new QHBoxLayout;
    QVBoxLayout* m_layout = new QVBoxLayout(this);
    QVBoxLayout* m_more = nullptr; ///< a hidden choice takes no room
};

} // namespace teleta::chrome
