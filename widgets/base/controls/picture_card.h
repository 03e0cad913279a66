// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QRectF>
#include <QWidget>

#include <functional>

class QHBoxLayout;
class QLabel;
class QPainter;
class QPushButton;

namespace teleta::base {

/// A choice with a large picture, a title, a sentence about it, and buttons that do it. Thread: GUI.
class PictureCard : public QWidget {
    Q_OBJECT

public:
    /// Draws into a rect; the ground is painted already.
    using Paint = std::function<void(QPainter&, const QRectF&, const QPalette&)>;

    explicit PictureCard(QWidget* parent = nullptr);

    void setPicture(Paint paint);
    void setTexts(const QString& title, const QString& about);
    /// A button below the sentence, to the right of those before it.
    QPushButton* addButton(const char* name);
    /// The height of the picture in px.
    void setPictureHeight(int height);
    /// So that its buttons keep their texts, in px.
    [[nodiscard]] int leastWidth() const;
    /// What the card needs besides its picture, at a width in px.
    [[nodiscard]] int textHeight(int width) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Paint m_paint;
    QWidget* m_picture;
    QLabel* m_title;
    QLabel* m_about;
    QHBoxLayout* m_buttons;
};

} // namespace teleta::base
