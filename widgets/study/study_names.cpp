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
    BuiltInName{"detection", "", QT_TRANSLATE_NOOP("StudyNames", "Tactor detection")},
    BuiltInName{"detection", "rest", QT_TRANSLATE_NOOP("StudyNames", "rest")},
    BuiltInName{"detection", "?",
                QT_TRANSLATE_NOOP("StudyNames", "In which interval did you feel a vibration?")},
    BuiltInName{"steps", "", QT_TRANSLATE_NOOP("StudyNames", "Intensity steps")},
    BuiltInName{"steps", "weak", QT_TRANSLATE_NOOP("StudyNames", "weak")},
    BuiltInName{"steps", "medium", QT_TRANSLATE_NOOP("StudyNames", "medium")},
    BuiltInName{"steps", "strong", QT_TRANSLATE_NOOP("StudyNames", "strong")},
    BuiltInName{"steps", "?", QT_TRANSLATE_NOOP("StudyNames", "Which interval was stronger?")},
    BuiltInName{"strength", "", QT_TRANSLATE_NOOP("StudyNames", "Equal strength")},
    BuiltInName{"strength", "rest", QT_TRANSLATE_NOOP("StudyNames", "rest")},
    BuiltInName{"strength", "?", QT_TRANSLATE_NOOP("StudyNames", "Which interval was stronger?")},
    BuiltInName{"taps", "", QT_TRANSLATE_NOOP("StudyNames", "Two or one")},
    BuiltInName{"taps", "rest", QT_TRANSLATE_NOOP("StudyNames", "rest")},
    BuiltInName{"taps", "?", QT_TRANSLATE_NOOP("StudyNames", "Did you feel two separate taps?")},
    BuiltInName{"motion", "", QT_TRANSLATE_NOOP("StudyNames", "Motion timing")},
    BuiltInName{"motion", "rest", QT_TRANSLATE_NOOP("StudyNames", "rest")},
    BuiltInName{"motion", "?", QT_TRANSLATE_NOOP("StudyNames", "Did you feel one moving point?")},
};

/// What the designs answer, translated by displayName().
[[maybe_unused]] constexpr std::array kAnswers{
    QT_TRANSLATE_NOOP("StudyNames", "yes"), QT_TRANSLATE_NOOP("StudyNames", "no"),
    QT_TRANSLATE_NOOP("StudyNames", "same"), QT_TRANSLATE_NOOP("StudyNames", "different")};

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
    // The answers of a design are the program's own words.
    if (task.design != Design::identification)
        return QCoreApplication::translate("StudyNames", pattern.name.c_str());
    return inLanguage(task, pattern.letter, pattern.name);
}

QString displayCondition(const StudyTask& task, const std::string& condition) {
    return inLanguage(task, condition, condition);
}

QString displayUnit(Vary vary) {
    switch (vary) {
    case Vary::intensity:
        return QCoreApplication::translate("StudyNames", "drive", "unit of a level");
    case Vary::balance:
        return QCoreApplication::translate("StudyNames", "balance", "unit of a level");
    case Vary::onset:
    case Vary::burst:
    case Vary::duration:
        break;
    }
    return QString::fromLatin1(unitOf(vary));
}

QString displayQuestion(const StudyTask& task) {
    if (!task.levels.question.empty())
        return inLanguage(task, "?", task.levels.question);
    switch (task.design) {
    case Design::identification:
        break;
    case Design::yesNo:
        return QCoreApplication::translate("StudyNames", "Was there a vibration?");
    case Design::interval:
        return QCoreApplication::translate("StudyNames", "Which interval had the vibration?");
    case Design::sameDifferent:
        return QCoreApplication::translate("StudyNames", "Were the two intervals the same?");
    case Design::compare:
        return QCoreApplication::translate("StudyNames", "Which interval had more?");
    }
    return {};
}

} // namespace teleta::study
