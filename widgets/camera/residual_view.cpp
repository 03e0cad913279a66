// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/residual_view.h"

#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"

#include <QKeyEvent>
#include <QMenu>

#include <array>

namespace teleta::camera {

namespace {

/// The data of the picture as CSV, C locale.
QString csvOf(const CalibratedPairs& shown) {
    QString text = QStringLiteral("u_px,v_px,x_m,y_m,z_m,used,kept,du_px,dv_px,error_m\n");
    const auto put = [&](std::optional<double> value, QChar separator) {
        text += base::csvNumber(value) + separator;
    };
    const vision::PairResidual none;
    for (std::size_t i = 0; i < shown.pairs.size(); ++i) {
        for (const double value : shown.pairs[i].pixel)
            put(value, u',');
        for (const double value : shown.pairs[i].p_Sensor_m)
            put(value, u',');
        put(shown.used[i] ? 1.0 : 0.0, u',');
        const vision::PairResidual& residual = shown.residuals.empty() ? none : shown.residuals[i];
        put(residual.kept ? 1.0 : 0.0, u',');
        put(residual.error_px ? std::optional(residual.error_px->x()) : std::nullopt, u',');
        put(residual.error_px ? std::optional(residual.error_px->y()) : std::nullopt, u',');
        put(residual.error_m, u'\n');
    }
    return text;
}

} // namespace

ResidualView::ResidualView(ResidualPicture::Surface surface, QWidget* parent)
    : PictureView(parent, {32, 16}, {13, 12}) {
    m_picture.surface = surface;
    base::keepTranslated(this, &ResidualView::retranslate);
}

void ResidualView::retranslate() {
    const bool image = m_picture.surface == ResidualPicture::Surface::image;
    setAccessibleName(image ? tr("Residuals on the image") : tr("Residuals on the unrolled cylinder"));
    setWhatsThis(
        image
            ? tr("<p>Each pair at its pixel, with an enlarged arrow to where the camera projects its point. "
                 "Random arrows are noise; a pattern shows something that the camera model "
                 "misses.</p><p>Pixels outside the dashed circle have no ray.</p>")
            : tr("<p>Each pair at its point on the cylinder, cut open at the back, with an enlarged arrow to "
                 "where "
                 "its pixel is located. The colour is the error along the axis.</p>"));
    update();
}

void ResidualView::setPairs(const CalibratedPairs& pairs) {
    m_picture.shown = pairs;
    if (m_picture.selected && *m_picture.selected >= pairs.pairs.size())
        m_picture.selected.reset();
    update();
}

void ResidualView::select(std::optional<std::size_t> pair) {
    m_picture.selected = pair;
    setAccessibleDescription(pair ? wordsFor(*pair) : QString());
    update();
}

QString ResidualView::wordsFor(std::size_t pair) const {
    using State = CalibratedPairs::State;
    QString text = tr("Pair %1").arg(pair + 1);
    static constexpr std::array kStates{"", QT_TR_NOOP("kept"), QT_TR_NOOP("left out as wrong"),
                                        QT_TR_NOOP("excluded by you")};
    if (const State state = m_picture.shown.state(pair); state != State::unknown)
        text += QStringLiteral(": ") + tr(kStates[static_cast<std::size_t>(state)]);
    if (m_picture.shown.residuals.empty())
        return text;
    const vision::PairResidual& residual = m_picture.shown.residuals[pair];
    if (residual.error_px)
        text += QStringLiteral("\n") +
                tr("off by %1 in the image")
                    .arg(base::withUnit(base::threeDigits(residual.error_px->norm()).trimmed(),
                                        QStringLiteral("px")));
    if (residual.error_m)
        text +=
            QStringLiteral("\n") + tr("off by %1 on the cylinder").arg(base::millimetres(*residual.error_m));
    return text;
}

base::Figure ResidualView::figure() {
    ResidualPicture picture = m_picture;
    picture.selected.reset();
    return figureOf(m_picture.surface == ResidualPicture::Surface::image ? tr("residuals-image")
                                                                         : tr("residuals-cylinder"),
                    picture, [pairs = m_picture.shown] { return csvOf(pairs); });
}

QString ResidualView::toolTipAt(const QPointF& point) const {
    const auto pair = m_picture.pairAt(point, QSizeF(size()));
    return pair ? wordsFor(*pair) : QString();
}

void ResidualView::mousePressEvent(QMouseEvent* event) {
    m_picture.font = font();
    const auto pair = m_picture.pairAt(event->position(), QSizeF(size()));
    if (event->button() == Qt::LeftButton && pair) {
        select(pair);
        emit selected(*pair);
    }
    QWidget::mousePressEvent(event);
}

void ResidualView::keyPressEvent(QKeyEvent* event) {
    const std::size_t count = m_picture.shown.pairs.size();
    const int step = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down ? 1
                     : event->key() == Qt::Key_Left || event->key() == Qt::Key_Up  ? -1
                                                                                   : 0;
    if (step != 0 && count > 0) {
        const std::size_t start = m_picture.selected.value_or(step > 0 ? count - 1 : 0);
        select((start + count + static_cast<std::size_t>(step + 1) - 1) % count);
        emit selected(*m_picture.selected);
    } else if (event->key() == Qt::Key_Delete && m_picture.selected) {
        emit toggleRequested(*m_picture.selected);
    } else {
        FigureView::keyPressEvent(event);
    }
}

void ResidualView::addOwnActions(QMenu& menu, const QPoint& position) {
    if (const auto pair = m_picture.pairAt(position, QSizeF(size())))
        menu.addAction(m_picture.shown.used[*pair] ? tr("&Exclude pair %1").arg(*pair + 1)
                                                   : tr("&Use pair %1 again").arg(*pair + 1),
                       this, [this, pair] { emit toggleRequested(*pair); });
}

} // namespace teleta::camera
