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

    DemoCard(base::Icon icon, const QString& title, const QString& about, QWidget* parent = nullptr);

    void setPicture(const QImage& picture);
    [[nodiscard]] bool hasPicture() const { return !m_picture.isNull(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    base::Icon m_icon;
    QString m_about;
    QImage m_picture;
};

} // namespace teleta::chrome
