// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/scene/scene_tile.h"

#include "widgets/base/controls/status_glyph.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"

#include <algorithm>

namespace teleta::camera {

using core::DeviceState;

SceneTile::SceneTile(QWidget* parent)
    : PictureView(parent, {20, 16}, {9, 8}) {
    base::keepTranslated(this, &SceneTile::retranslate);
}

void SceneTile::setName(const QString& name) {
    if (name == m_picture.name)
        return;
    m_picture.name = name;
    describe();
    update();
}

void SceneTile::setImage(const core::ColourImage& image) {
    const bool isOther =
        image.width_px != m_picture.image.width_px || image.height_px != m_picture.image.height_px;
    m_picture.image = image;
    if (isOther) {
        m_numbers_ns = 0;
        emit shapeChanged();
    }
    update();
}

QString SceneTile::problemOf(const SceneReading& reading) const {
    const bool isOver = reading.state == DeviceState::paused || reading.state == DeviceState::finished ||
                        reading.state == DeviceState::closed;
    if (isOver)
        return {};
    if (m_picture.isEmpty())
        return tr("Waiting for the first picture");
    const bool isLost = reading.state == DeviceState::lost || reading.state == DeviceState::reconnecting;
    // A slow camera is live between its pictures.
    if (!isLost && (reading.state == DeviceState::live || reading.age_s <= kOldest_s))
        return {};
    return tr("No picture for %1").arg(base::ageText(reading.age_s));
}

void SceneTile::setReading(const SceneReading& reading) {
    const QString problem = problemOf(reading);
    const QString reason = problem.isEmpty() ? QString() : reading.reason;
    m_oldest_s = problem.isEmpty() ? std::max(m_oldest_s, reading.age_s) : 0.0;
    bool changed =
        reading.state != m_picture.state || problem != m_picture.problem || reason != m_picture.reason;
    const bool isNow = problem.isEmpty() && reading.state == DeviceState::live && !m_picture.isEmpty();
    const double waited_s = static_cast<double>(reading.now_ns - m_numbers_ns) * 1e-9;
    if (m_numbers_ns == 0 || changed || waited_s >= kNumbersEvery_s) {
        m_numbers_ns = reading.now_ns;
        QStringList numbers;
        if (!m_picture.isEmpty())
            numbers << tr("%1 \u00d7 %2").arg(m_picture.image.width_px).arg(m_picture.image.height_px);
        m_rate_Hz.update(isNow && reading.rate_Hz > 0.0 ? std::optional(reading.rate_Hz) : std::nullopt);
        m_age_ms.update(isNow ? std::optional(1e3 * m_oldest_s) : std::nullopt);
        if (m_rate_Hz.shown())
            numbers << base::withUnit(m_rate_Hz.text(), tr("Hz"));
        if (m_age_ms.shown())
            numbers << base::withUnit(m_age_ms.text(), tr("ms"));
        m_oldest_s = 0.0;
        changed = changed || numbers != m_picture.numbers;
        m_picture.numbers = numbers;
    }
    if (!changed)
        return;
    m_picture.state = reading.state;
    m_picture.problem = problem;
    m_picture.reason = reason;
    describe();
    update();
}

base::Figure SceneTile::figure() {
    ScenePicture picture = m_picture;
    picture.font = font();
    // Figures are saved with two pixels for one of theirs.
    const QSizeF size = 0.5 * QSizeF(picture.image.width_px, picture.image.height_px);
    return {.name = m_picture.name.isEmpty() ? tr("scene") : m_picture.name,
            .size_px = size.isEmpty() ? QSizeF(1.0, 1.0) : size,
            .paint =
                [picture = std::move(picture), size](QPainter& painter) {
                    picture.paintAlone(painter, size, base::designedPalette(false));
                },
            .csv = [text = csv()] { return text; }};
}

QString SceneTile::csv() const {
    return QStringLiteral("width_px,height_px,rate_hz,age_ms\n%1,%2,%3,%4\n")
        .arg(m_picture.image.width_px)
        .arg(m_picture.image.height_px)
        .arg(base::csvNumber(m_rate_Hz.shown()), base::csvNumber(m_age_ms.shown()));
}

QString SceneTile::toolTipAt(const QPointF& /*point*/) const {
    return accessibleName() + QLatin1Char('\n') + accessibleDescription();
}

void SceneTile::describe() {
    setAccessibleName(tr("Picture of %1", "a camera").arg(m_picture.name));
    QStringList parts{base::statusWord(m_picture.state)};
    for (QString number : m_picture.numbers)
        parts << number.remove(QChar(0x2007));
    for (const QString& text : {m_picture.problem, m_picture.reason})
        if (!text.isEmpty())
            parts << text;
    setAccessibleDescription(parts.join(QStringLiteral(", ")));
}

void SceneTile::retranslate() {
    setWhatsThis(
        tr("<p>What a camera sees now. Above it stand the size of its pictures, how many come in a "
           "second, and the age of the one that is shown: the time since it was read.</p><p>A picture "
           "that is too old for the camera's rate is dimmed, and says for how long none has come.</p>"));
    m_numbers_ns = 0;
    describe();
    update();
}

} // namespace teleta::camera
