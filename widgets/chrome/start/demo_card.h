// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/icons.h"

#include <QAbstractButton>
#include <QImage>

namespace teleta::chrome {

/// Something to open: a picture of it, a title, and a line or two about it. Until there is a picture it shows
/// an icon. Thread: GUI.
class DemoCard : public QAbstractButton {
    Q_OBJECT

public:
    /// Size of the picture at scale 1, in em.
    static constexpr QSizeF kPicture_em{5.0, 3.25};

    enum class Size {
        large,
        small, ///< a small picture and the title alone; the rest is in the tool tip
    };
    /// A card may be a step, which has a mark in place of the picture.
    enum class Step {
        none,
        open,
        done,
    };

    DemoCard(base::Icon icon, const QString& title, const QString& about, QWidget* parent = nullptr);

    void setTexts(const QString& title, const QString& about);
    void setSize(Size size);
    void setStep(Step step);
    [[nodiscard]] Step step() const { return m_step; }
    void setPicture(const QImage& picture);
    [[nodiscard]] bool hasPicture() const { return !m_picture.isNull(); }
    /// Of a card in a widget.
    [[nodiscard]] static int heightOf(const QWidget& widget, Size size);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QSizeF picture_em() const;
    void describe();
    void paintStep(QPainter& painter, const QRectF& place) const;

    base::Icon m_icon;
    Size m_size = Size::large;
    Step m_step = Step::none;
    QString m_about;
    QImage m_picture;
};

} // namespace teleta::chrome
