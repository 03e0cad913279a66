// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/file_picture.h"

#include "app/common/scene_file.h"
#include "app/console/start/scene_picture.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/recording/recording.h"
#include "backend/recording/stream_columns.h"
#include "widgets/pattern/pattern_picture.h"

#include <QDateTime>
#include <QFileInfo>
#include <QPainter>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace teleta::console {

namespace {

constexpr char kPatternPlace[] = "pattern:";
constexpr char kStudyPlace[] = "study:";
constexpr std::array kStudyStimuli{"shape.A.static", "shape.B.static", "shape.C.static", "shape.D.static"};
constexpr int kLooks = 12; ///< places in a recording that are looked at

core::Unexpected noPicture(const QString& place) {
    return core::Unexpected(
        core::Error{core::ErrorKind::notFound, "There is no picture of " + place.toStdString(), {}, {}});
}

core::Unexpected stoppedPicture() {
    return core::Unexpected(core::Error{core::ErrorKind::cancelled, "The picture was stopped.", {}, {}});
}

core::Expected<QImage> pictureOfPattern(const QString& id, const QSize& size, const QPalette& palette) {
    const pattern::Pattern* known = pattern::findBuiltIn(id.toStdString());
    if (known == nullptr)
        return noPicture(id);
    return pattern::patternPicture(*known, size, palette);
}

/// Two by two.
core::Expected<QImage> pictureOfStudy(const QSize& size, const QPalette& palette) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(palette.color(QPalette::Window));
    QPainter painter(&image);
    const int gap = std::max(1, size.height() / 20);
    const QSize each((size.width() - gap) / 2, (size.height() - gap) / 2);
    for (std::size_t i = 0; i < kStudyStimuli.size(); ++i) {
        TELETA_TRY(const QImage part, pictureOfPattern(QLatin1String(kStudyStimuli[i]), each, palette));
        painter.drawImage(QPoint(static_cast<int>(i % 2) * (each.width() + gap),
                                 static_cast<int>(i / 2) * (each.height() + gap)),
                          part);
    }
    return image;
}

core::Expected<QImage> pictureOfRecording(const QString& path, const QSize& size, const QPalette& palette,
                                          const std::stop_token& stop) {
    TELETA_TRY(const recording::Recording opened, recording::Recording::open(path.toStdString()));
    const auto stream = opened.first(recording::StreamKind::array);
    if (!stream)
        return noPicture(path);
    const recording::StreamInfo& info = opened.streams()[*stream];
    TELETA_TRY(const auto extent, opened.extent(*stream));
    if (info.shape.size() != 2 || recording::isVectorArray(info) ||
        info.type != recording::ValueType::float32 || !extent)
        return noPicture(path);
    recording::StreamReader reader = opened.reader(*stream);
    const std::size_t taxels = info.channels();
    std::vector<float> strongest;
    float widest = -1.0F;
    core::TappedFrames block;
    for (int look = 0; look < kLooks; ++look) {
        if (stop.stop_requested())
            return stoppedPicture();
        const std::int64_t at_ns = extent->first_ns + (extent->last_ns - extent->first_ns) / kLooks * look;
        TELETA_CHECK(reader.seek(at_ns));
        // A damaged block has no picture; another one will do.
        const auto more = reader.next(block);
        if (!more || !*more || block.frames() == 0 || taxels == 0)
            continue;
        const auto values = recording::valuesOf<float>(block, 0, taxels);
        const auto [least, most] = std::ranges::minmax(values);
        if (most - least > widest) {
            widest = most - least;
            strongest.assign(values.begin(), values.end());
            for (float& value : strongest)
                value -= least;
        }
    }
    if (strongest.empty())
        return noPicture(path);
    const core::ArrayLayout layout{.rows = static_cast<int>(info.shape[0]),
                                   .columns = static_cast<int>(info.shape[1])};
    return loadPicture(strongest, layout, size, palette);
}

} // namespace

core::Expected<QImage> startPicture(const QString& place, const QSize& size, const QPalette& palette,
                                    const std::stop_token& stop) {
    if (stop.stop_requested())
        return stoppedPicture();
    if (place.startsWith(QLatin1String(kPatternPlace)))
        return pictureOfPattern(place.mid(static_cast<qsizetype>(sizeof(kPatternPlace) - 1)), size, palette);
    if (place.startsWith(QLatin1String(kStudyPlace)))
        return pictureOfStudy(size, palette);
    if (place.endsWith(QLatin1String(".teleta"), Qt::CaseInsensitive))
        return pictureOfRecording(place, size, palette, stop);
    if (!place.endsWith(QLatin1String(".toml"), Qt::CaseInsensitive))
        return noPicture(place);
    TELETA_TRY(const scene::Scene scene, app::readScene(place.toStdString()));
    return scenePicture(scene, size, palette, stop);
}

QByteArray startPictureKey(const QString& place) {
    if (place.endsWith(QLatin1String(".toml"), Qt::CaseInsensitive))
        return QByteArray::fromStdString(app::readSceneText(place.toStdString()));
    const QFileInfo file(place);
    return place.toUtf8() + '|' + QByteArray::number(file.size()) + '|' +
           QByteArray::number(file.lastModified().toMSecsSinceEpoch());
}

} // namespace teleta::console
