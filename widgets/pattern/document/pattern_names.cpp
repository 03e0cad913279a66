// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/document/pattern_names.h"

#include "backend/pattern/model/built_in_patterns.h"

#include <QCoreApplication>

namespace teleta::pattern {

namespace {

/// Names as in built_in_patterns.cpp; in files they stay English.
[[maybe_unused]] constexpr const char* kBuiltInNames[] = {
    QT_TRANSLATE_NOOP("PatternNames", "Circle, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Rectangle, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Triangle, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Arc, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Line, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Point, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Circle, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Rectangle, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Triangle, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Arc, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Line, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Point, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Sponge, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Rubber sponge, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Rubber, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Wood, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Metal, static"),
    QT_TRANSLATE_NOOP("PatternNames", "Sponge, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Rubber sponge, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Rubber, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Wood, dynamic"),
    QT_TRANSLATE_NOOP("PatternNames", "Metal, dynamic"),
};

} // namespace

QString displayName(const Pattern& pattern) {
    // A copy may keep the id, and a file may contain any id, so the name has to match, too.
    const Pattern* builtIn = findBuiltIn(pattern.id);
    return builtIn != nullptr && builtIn->name == pattern.name
               ? QCoreApplication::translate("PatternNames", pattern.name.c_str())
               : QString::fromStdString(pattern.name);
}

} // namespace teleta::pattern
