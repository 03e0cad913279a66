// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"
#include "devices/foxglove/live_view.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QEventLoop>

#include <array>
#include <functional>
#include <memory>
#include <span>

namespace teleta::test {

inline constexpr int kPatience_ms = 20'000;

/// Sockets need an application.
inline void makeApplication() {
    static int argc = 1;
    static std::array<char, 5> name{"test"};
    static std::array<char*, 2> argv{name.data(), nullptr};
    static const QCoreApplication kApplication(argc, argv.data());
}

/// Handles events until the condition holds; false when it does not for too long.
inline bool waitUntil(const std::function<bool()>& condition) {
    QDeadlineTimer deadline(kPatience_ms);
    while (!condition()) {
        if (deadline.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    return true;
}

inline recording::StreamInfo skinInfo() {
    return {.name = "skin",
            .kind = recording::StreamKind::array,
            .type = recording::ValueType::float32,
            .source = "skin",
            .shape = {2, 3},
            .unit = "N",
            .details = R"({"pitch_m":0.0034})"};
}

inline std::int64_t appendSkin(core::StreamTap& tap, float first) {
    const std::array<float, 6> values{first, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F};
    const std::int64_t time_ns = core::steadyNow_ns();
    tap.append(time_ns, static_cast<double>(time_ns) * 1e-9, std::span<const float>(values));
    return time_ns;
}

inline std::unique_ptr<foxglove::LiveView> listeningView() {
    makeApplication();
    auto view = std::make_unique<foxglove::LiveView>(foxglove::LiveViewOptions{.port = 0});
    const bool isListening =
        waitUntil([&] { return view->status().state == foxglove::LiveViewStatus::State::listening; });
    return isListening ? std::move(view) : nullptr;
}

} // namespace teleta::test
