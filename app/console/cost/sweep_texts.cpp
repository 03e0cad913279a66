// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/sweep_texts.h"

#include <QCoreApplication>

#include <array>

namespace teleta::console {

namespace {

class SweepTexts {
    Q_DECLARE_TR_FUNCTIONS(SweepTexts)

public:
    static SweepText of(const QString& name) {
        struct Known {
            const char* name;
            const char* topic;
            const char* title;
            const char* about;
        };
        static constexpr std::array kKnown{
            Known{"camera-place", QT_TR_NOOP("Camera"), QT_TR_NOOP("Contact by place and depth"),
                  QT_TR_NOOP("How exactly does the camera in the soft tube find a finger along the tube?")},
            Known{"touch-stiffness", QT_TR_NOOP("Touched object"), QT_TR_NOOP("Stiffness by noise and speed"),
                  QT_TR_NOOP("Over which stiffnesses, noises and speeds does a touch find the stiffness?")},
            Known{"contour-ladder", QT_TR_NOOP("Touched object"), QT_TR_NOOP("Curve through contact points"),
                  QT_TR_NOOP("How far is the curve from the outline, and how long does it take?")},
            Known{"servo-friction", QT_TR_NOOP("Servo"), QT_TR_NOOP("Bent bar by friction and latency"),
                  QT_TR_NOOP("Over which radii, frictions and latencies does the array follow the bar?")},
            Known{"labelled-frames", QT_TR_NOOP("Frames to learn from"), QT_TR_NOOP("Two balls on an array"),
                  QT_TR_NOOP("A million frames, with where and how hard each ball presses.")},
            Known{
                "labelled-servo-frames", QT_TR_NOOP("Frames to learn from"),
                QT_TR_NOOP("An array along a bent bar"),
                QT_TR_NOOP("A million frames, with where, how hard and along which normal it is pressed.")}};
        for (const Known& known : kKnown)
            if (name == QLatin1String(known.name))
                return {tr(known.topic), tr(known.title), tr(known.about)};
        return {{}, name, {}};
    }
};

} // namespace

SweepText sweepText(const QString& name) {
    return SweepTexts::of(name);
}

} // namespace teleta::console
