// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/study_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string_view>

namespace teleta::study {

namespace {

struct BuiltInName {
    std::string_view task;
    std::string_view part; ///< a letter, a condition; empty: the task itself
    const char* name;
};

/// Names as in resources/studies. Names that somebody has changed are not translated.
constexpr std::array kBuiltInNames{
    BuiltInName{"shape", "", QT_TRANSLATE_NOOP("StudyNames", "Object shape")},
    BuiltInName{"shape", "A", QT_TRANSLATE_NOOP("StudyNames", "circle")},
    BuiltInName{"shape", "B", QT_TRANSLATE_NOOP("StudyNames", "rectangle")},
    BuiltInName{"shape", "C", QT_TRANSLATE_NOOP("StudyNames", "triangle")},
    BuiltInName{"shape", "D", QT_TRANSLATE_NOOP("StudyNames", "arc")},
    BuiltInName{"shape", "E", QT_TRANSLATE_NOOP("StudyNames", "line")},
    BuiltInName{"shape", "F", QT_TRANSLATE_NOOP("StudyNames", "point")},
    BuiltInName{"shape", "static", QT_TRANSLATE_NOOP("StudyNames", "static")},
    BuiltInName{"shape", "dynamic", QT_TRANSLATE_NOOP("StudyNames", "dynamic")},
    BuiltInName{"stiffness", "", QT_TRANSLATE_NOOP("StudyNames", "Object stiffness")},
    BuiltInName{"stiffness", "A", QT_TRANSLATE_NOOP("StudyNames", "sponge")},
    BuiltInName{"stiffness", "B", QT_TRANSLATE_NOOP("StudyNames", "rubber sponge")},
    BuiltInName{"stiffness", "C", QT_TRANSLATE_NOOP("StudyNames", "rubber")},
    BuiltInName{"stiffness", "D", QT_TRANSLATE_NOOP("StudyNames", "wood")},
    BuiltInName{"stiffness", "E", QT_TRANSLATE_NOOP("StudyNames", "metal")},
    BuiltInName{"stiffness", "static", QT_TRANSLATE_NOOP("StudyNames", "static")},
    BuiltInName{"stiffness", "dynamic", QT_TRANSLATE_NOOP("StudyNames", "dynamic")},
};

QString inLanguage(const StudyTask& task, std::string_view part, const std::string& name) {
    const bool isBuiltIn =
        std::any_of(kBuiltInNames.begin(), kBuiltInNames.end(), [&](const BuiltInName& known) {
            return known.task == task.id && known.part == part && known.name == name;
        });
    return isBuiltIn ? QCoreApplication::translate("StudyNames", name.c_str()) : QString::fromStdString(name);
}

} // namespace

QString displayName(const StudyTask& task) {
    return inLanguage(task, {}, task.name);
}

QString displayName(const StudyTask& task, const StudyPattern& pattern) {
    return inLanguage(task, pattern.letter, pattern.name);
}

QString displayCondition(const StudyTask& task, const std::string& condition) {
    return inLanguage(task, condition, condition);
}

} // namespace teleta::study
