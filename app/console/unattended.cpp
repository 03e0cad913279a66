// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/unattended.h"

#include "app/console/main_window.h"
#include "app/console/process_times.h"
#include "app/console/study/study_page.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/pipeline/touch_channel.h"

#include <QApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPixmap>
#include <QSaveFile>
#include <QTimer>

#include <cstdio>

namespace teleta::console {

namespace {

/// The first second belongs to start-up: windows are laid out and OpenGL compiles its shaders.
constexpr double kWarmUp_s = 1.0;

int milliseconds(double time_s) {
    return static_cast<int>(time_s * 1e3);
}

} // namespace

Unattended::Unattended(const ConsoleOptions& options, MainWindow& window)
    : m_options(options)
    , m_window(window) {
}

void Unattended::start() {
    if (!m_options.screenshot.isEmpty())
        QTimer::singleShot(milliseconds(m_options.after_s), this, &Unattended::takePicture);
    if (m_options.measure_s) {
        m_window.installEventFilter(this);
        QTimer::singleShot(milliseconds(kWarmUp_s), this, [this] {
            m_window.clock().resetReport();
            m_processorBefore_s = processorTime_s();
            m_measured.start();
        });
        QTimer::singleShot(milliseconds(kWarmUp_s + *m_options.measure_s), this,
                           &Unattended::printMeasurement);
    }
}

bool Unattended::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint) {
        m_window.removeEventFilter(this);
        // Once all that belongs to this picture is painted and handed to the screen.
        QTimer::singleShot(0, this, [this] {
            m_firstWindow_s = processAge_s();
            m_firstWindowProcessor_s = processorTime_s();
        });
    }
    return QObject::eventFilter(watched, event);
}

void Unattended::takePicture() {
    QSaveFile file(m_options.screenshot);
    QWidget* other = m_window.studyPage().forwardWindow();
    QWidget& window = other != nullptr ? *other : static_cast<QWidget&>(m_window);
    const bool saved = file.open(QIODevice::WriteOnly) && window.grab().save(&file, "PNG") && file.commit();
    if (!saved)
        std::fprintf(stderr, "%s\n",
                     qPrintable(tr("teleta-console: %1: cannot write the picture: %2")
                                    .arg(m_options.screenshot, file.errorString())));
    const int code = !saved ? 1 : m_window.anyFailure() ? 3 : 0;
    m_window.close();
    QApplication::exit(code);
}

void Unattended::printMeasurement() {
    const double measured_s = 1e-9 * static_cast<double>(m_measured.nsecsElapsed());
    const double cores = (processorTime_s() - m_processorBefore_s) / measured_s;
    const GuiClock::Report report = m_window.clock().report();
    QJsonArray sources;
    for (const SourceManager::Item& item : m_window.sources().items()) {
        if (!item.isOpen())
            continue;
        const core::DeviceStatus status = item.channel->status();
        const auto array = item.array();
        const bool isCounted = !array || array->countsLosses() || status.framesLost > 0;
        sources.append(
            QJsonObject{{"name", item.name},
                        {"rate_hz", status.rate_Hz},
                        {"frames_processed", static_cast<qint64>(item.channel->framesProcessed())},
                        {"frames_lost", isCounted ? QJsonValue(static_cast<qint64>(status.framesLost))
                                                  : QJsonValue(QJsonValue::Null)},
                        {"frames_displayed", static_cast<qint64>(item.displayed)}});
    }
    QJsonObject document{{"first_window_s", m_firstWindow_s},
                         {"first_window_processor_s", m_firstWindowProcessor_s},
                         {"measured_s", measured_s},
                         {"ticks", static_cast<qint64>(report.ticks)},
                         {"processor_cores", cores},
                         {"tick_work_p50_s", report.work_p50_s},
                         {"tick_work_p99_s", report.work_p99_s},
                         {"tick_work_max_s", report.work_max_s},
                         {"event_loop_stall_p99_s", report.stall_p99_s},
                         {"event_loop_stall_max_s", report.stall_max_s},
                         {"sources", sources}};
    if (const std::optional<TouchToSkin::Latency> latency = m_window.bracelet().touchToSkin()) {
        document.insert("touch_to_bracelet_p50_s", latency->median_s);
        document.insert("touch_to_bracelet_p99_s", latency->p99_s);
        document.insert("touches", static_cast<qint64>(m_window.bracelet().receipts().size()));
    }
    std::printf("%s", QJsonDocument(document).toJson().constData());
    std::fflush(stdout);
    const int code = m_window.anyFailure() ? 3 : 0;
    m_window.close();
    QApplication::exit(code);
}

} // namespace teleta::console
