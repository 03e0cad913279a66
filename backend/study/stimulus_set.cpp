// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/stimulus_set.h"

#include "backend/pattern/built_in_patterns.h"
#include "backend/pattern/pattern_json.h"

#include <QByteArray>
#include <QCryptographicHash>

#include <utility>

namespace teleta::study {

std::string stimulusId(const StudyTask& task, const StudyPattern& pattern, const std::string& condition) {
    return task.id + '.' + pattern.letter + '.' + condition;
}

std::string stimulusSetSha256(const Protocol& protocol) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const auto add = [&hash](const std::string& text) {
        hash.addData(QByteArray::fromStdString(text));
        hash.addData(QByteArrayLiteral("\n"));
    };
    for (const StudyTask& task : protocol.tasks) {
        for (const std::string& condition : task.conditions) {
            for (const StudyPattern& pattern : task.patterns) {
                const std::string id = stimulusId(task, pattern, condition);
                add(id);
                if (const pattern::Pattern* builtIn = pattern::findBuiltIn(id))
                    add(pattern::patternToJson(*builtIn).value_or(std::string()));
            }
        }
    }
    return hash.result().toHex().toStdString();
}

std::vector<std::string> missingStimuli(const Protocol& protocol) {
    std::vector<std::string> missing;
    for (const StudyTask& task : protocol.tasks) {
        for (const std::string& condition : task.conditions) {
            for (const StudyPattern& pattern : task.patterns) {
                std::string id = stimulusId(task, pattern, condition);
                if (pattern::findBuiltIn(id) == nullptr)
                    missing.push_back(std::move(id));
            }
        }
    }
    return missing;
}

} // namespace teleta::study
