// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/timeline/timeline_menu.h"

#include "widgets/pattern/timeline/timeline_painter.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMenu>

#include <cmath>

namespace teleta::pattern {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("Timeline", text);
}

constexpr std::array kScales{0.5, 0.8, 1.25, 2.0};

} // namespace

QString easingName(Easing easing) {
    static constexpr std::array<const char*, kEasings.size()> kNames{
        QT_TRANSLATE_NOOP("Timeline", "linear"), QT_TRANSLATE_NOOP("Timeline", "hold"),
        QT_TRANSLATE_NOOP("Timeline", "ease in"), QT_TRANSLATE_NOOP("Timeline", "ease out"),
        QT_TRANSLATE_NOOP("Timeline", "ease in and out")};
    return tr(kNames[static_cast<std::size_t>(easing)]);
}

QString valueText(std::size_t track, double time_s, double intensity, const MotorProfile& motor) {
    const QLocale locale;
    const double speed_Hz = steadySpeed_Hz(motor, driveOf(motor, intensity));
    return QCoreApplication::translate("Timeline", "Motor %1 at %2\u00b0\n%3 s: %4 %, %5 Hz")
        .arg(track + 1)
        .arg(track * 360 / core::kTactors)
        .arg(locale.toString(time_s, 'f', 3), locale.toString(100.0 * intensity, 'f', 1),
             locale.toString(speed_Hz, 'f', 0));
}

QString pointText(std::size_t track, const Breakpoint& point, const MotorProfile& motor) {
    return valueText(track, point.time_s, point.intensity, motor) + QLatin1Char('\n') +
           easingName(point.easing);
}

QString objectText(const PatternObject& object) {
    const QLocale locale;
    const Span span = spanOf(object.form);
    return QCoreApplication::translate("Timeline", "%1: %2 to %3 s")
        .arg(objectTitle(object), locale.toString(span.begin_s, 'f', 3), locale.toString(span.end_s, 'f', 3));
}

void fillTimelineMenu(QMenu& menu, PatternDocument& document, double playhead_s) {
    const Selection& selection = document.selection();
    const auto add = [&](const char* text, const QKeySequence& keys, bool enabled, auto act) {
        QAction* action = menu.addAction(tr(text), &document, act);
        action->setShortcut(keys); // for display only: the view handles the keys itself
        action->setShortcutContext(Qt::WidgetShortcut);
        action->setEnabled(enabled);
    };
    const bool some = !selection.empty();
    add(QT_TRANSLATE_NOOP("Timeline", "Cu&t"), QKeySequence::Cut, some, [&document] { document.cut(); });
    add(QT_TRANSLATE_NOOP("Timeline", "&Copy"), QKeySequence::Copy, some, [&document] { document.copy(); });
    add(QT_TRANSLATE_NOOP("Timeline", "&Paste in place"), QKeySequence::Paste, document.canPaste(),
        [&document] { document.paste(); });
    add(QT_TRANSLATE_NOOP("Timeline", "Paste at play&head"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V),
        document.canPaste(), [&document, playhead_s] { document.paste(playhead_s); });
    add(QT_TRANSLATE_NOOP("Timeline", "&Duplicate"), QKeySequence(Qt::CTRL | Qt::Key_D), some,
        [&document] { document.duplicate(); });
    add(QT_TRANSLATE_NOOP("Timeline", "De&lete"), QKeySequence(Qt::Key_Delete), some,
        [&document] { document.deleteSelection(); });
    menu.addSeparator();
    add(QT_TRANSLATE_NOOP("Timeline", "O&verdrive: make the motors start faster"), {}, true,
        [&document] { document.overdrive(); });
    if (!selection.points.empty()) {
        QMenu* curve = menu.addMenu(tr(QT_TRANSLATE_NOOP("Timeline", "C&urve from here")));
        for (const Easing easing : kEasings)
            curve->addAction(easingName(easing), &document,
                             [&document, easing] { document.setEasing(easing); });
        QMenu* scale = menu.addMenu(tr(QT_TRANSLATE_NOOP("Timeline", "&Scale intensity")));
        for (const double factor : kScales)
            scale->addAction(QStringLiteral("\u00d7 %1").arg(QLocale().toString(factor)), &document,
                             [&document, factor] { document.scaleIntensity(factor); });
    }
    if (selection.object)
        menu.addAction(tr(QT_TRANSLATE_NOOP("Timeline", "Ba&ke into breakpoints")), &document,
                       [&document, object = *selection.object] { document.bakeObject(object); });
}

std::vector<double> numbersIn(const QString& text) {
    std::vector<double> numbers;
    const QLocale locale;
    for (const QString& part : text.split(QLatin1Char(';'))) {
        QString digits;
        for (const QChar c : part)
            if (c.isDigit() || c == locale.decimalPoint() || c == QLatin1Char('.') || c == QLatin1Char('-') ||
                c == QLatin1Char('e'))
                digits += c;
            else if (c == QChar(0x2212))
                digits += QLatin1Char('-');
        bool ok = false;
        double value = locale.toDouble(digits, &ok);
        if (!ok)
            value = QLocale::c().toDouble(digits, &ok);
        if (!ok || !std::isfinite(value))
            return {};
        numbers.push_back(value);
    }
    return numbers;
}

} // namespace teleta::pattern
