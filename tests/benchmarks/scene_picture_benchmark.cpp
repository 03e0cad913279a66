// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a scene camera, 640 x 480, painted in colour into a dock: ours (shared pixels, converted,
// then scaled) against QPainter alone, which converts while it scales, and against QImage::scaled(). Also the
// way of a picture through the channel. One core.
#include "backend/pipeline/scene_camera_channel.h"
#include "widgets/base/theme.h"
#include "widgets/base/tokens.h"
#include "widgets/camera/scene/scene_picture.h"

#include <QGuiApplication>
#include <QPainter>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace {

using namespace teleta;

core::ColourImage drawn(int width_px, int height_px) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>();
    for (int i = 0; i < 3 * width_px * height_px; ++i)
        bytes->push_back(static_cast<std::uint8_t>(i * 7));
    return {{bytes, bytes->data()}, width_px, height_px};
}

/// paint(painter, size): size of the view in px.
template <typename Paint>
void paintInto(benchmark::State& state, const Paint& paint) {
    const QSizeF size(static_cast<double>(state.range(0)), static_cast<double>(state.range(1)));
    QImage screen(size.toSize(), QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&screen);
    for (auto _ : state)
        paint(painter, size);
}

void ours(benchmark::State& state) {
    camera::ScenePicture picture;
    picture.image = drawn(640, 480);
    picture.name = QStringLiteral("front");
    picture.state = core::DeviceState::live;
    picture.numbers = {QStringLiteral("640 x 480"), QStringLiteral("30.0 Hz"), QStringLiteral("33 ms")};
    const QPalette palette = base::designedPalette(true);
    paintInto(state, [&](QPainter& painter, const QSizeF& size) { picture.paint(painter, size, palette); });
}
BENCHMARK(ours)->Args({300, 250})->Args({900, 700})->Unit(benchmark::kMillisecond);

void painterAlone(benchmark::State& state) {
    camera::ScenePicture picture;
    picture.image = drawn(640, 480);
    paintInto(state, [&](QPainter& painter, const QSizeF& size) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(picture.imageRect(size), picture.shared());
    });
}
BENCHMARK(painterAlone)->Args({300, 250})->Args({900, 700})->Unit(benchmark::kMillisecond);

void scaledImage(benchmark::State& state) {
    camera::ScenePicture picture;
    picture.image = drawn(640, 480);
    paintInto(state, [&](QPainter& painter, const QSizeF& size) {
        const QRectF place = picture.imageRect(size);
        painter.drawImage(
            place.topLeft(),
            picture.shared().scaled(place.size().toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    });
}
BENCHMARK(scaledImage)->Args({300, 250})->Args({900, 700})->Unit(benchmark::kMillisecond);

/// Gives the same picture whenever it is asked.
class EndlessCamera : public core::CameraSource {
public:
    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& /*consumer*/) override {}
    void stop() override {}
    bool pop(core::CameraFrame& frame) override {
        m_given = !m_given;
        if (m_given)
            frame.image = m_image;
        return m_given;
    }
    [[nodiscard]] core::DeviceStatus status() const override { return {}; }

private:
    core::CameraDescription m_description;
    core::GreyImage m_image = core::bytesOf(drawn(640, 480));
    bool m_given = false;
};

void throughTheChannel(benchmark::State& state) {
    pipeline::SceneCameraChannel channel(std::make_unique<EndlessCamera>());
    for (auto _ : state) {
        benchmark::DoNotOptimize(channel.process());
        benchmark::DoNotOptimize(channel.update());
    }
}
BENCHMARK(throughTheChannel)->Unit(benchmark::kMicrosecond);

} // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
