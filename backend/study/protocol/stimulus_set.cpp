// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/stimulus_set.h"

#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/study/protocol/trial_pattern.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

struct StimulusText {
    Q_DECLARE_TR_FUNCTIONS(StimulusText)
};

/// Calls use(id, file) for all stimuli in order; file: empty where the protocol names none.
template <typename Use>
void forEachStimulus(const Protocol& protocol, const Use& use) {
    for (const StudyTask& task : protocol.tasks) {
        if (task.design != Design::identification) {
            use(levelStimulusId(task), task.levels.file);
            continue;
        }
        for (const std::string& condition : task.conditions) {
            for (const StudyPattern& pattern : task.patterns) {
                const auto file = pattern.files.find(condition);
                use(stimulusId(task, pattern, condition),
                    file == pattern.files.end() ? std::string() : file->second);
            }
        }
    }
}

const OwnStimulus* findIn(const std::vector<OwnStimulus>& own, const std::string& id) {
    const auto found = std::ranges::find(own, id, &OwnStimulus::id);
    return found == own.end() ? nullptr : &*found;
}

} // namespace

std::string stimulusId(const StudyTask& task, const StudyPattern& pattern, const std::string& condition) {
    return task.id + '.' + pattern.letter + '.' + condition;
}

std::string levelStimulusId(const StudyTask& task) {
    return task.id + ".stimulus";
}

core::Expected<std::vector<OwnStimulus>> readOwnStimuli(const Protocol& protocol) {
    std::vector<OwnStimulus> own;
    std::optional<core::Error> failed;
    forEachStimulus(protocol, [&](const std::string& id, const std::string& file) {
        if (file.empty() || failed)
            return;
        if (const pattern::Pattern* builtIn = pattern::findBuiltIn(file)) {
            own.push_back({id, file, pattern::patternToJson(*builtIn).value_or(std::string())});
            return;
        }
        const QFileInfo info(QString::fromStdString(file));
        if (info.isRelative()) {
            failed = core::Error{core::ErrorKind::refused,
                                 StimulusText::tr("the folder of this pattern is unknown").toStdString(),
                                 StimulusText::tr("the full path of the file").toStdString(),
                                 {file}};
            return;
        }
        const auto json = pattern::loadPattern(file).and_then(
            [&](const pattern::Pattern& pattern) -> core::Expected<std::string> {
                for (const StudyTask& task : protocol.tasks) {
                    if (task.design == Design::identification || levelStimulusId(task) != id)
                        continue;
                    if (const auto fits = checkStimulus(protocol, task, pattern); !fits) {
                        core::Error error = fits.error();
                        error.where = {file};
                        return core::Unexpected(error);
                    }
                }
                return pattern::patternToJson(pattern);
            });
        if (json)
            own.push_back({id, info.fileName().toStdString(), *json});
        else
            failed = json.error();
    });
    if (failed)
        return core::Unexpected(*failed);
    return own;
}

std::string stimulusSetSha256(const Protocol& protocol, const std::vector<OwnStimulus>& own) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const auto add = [&hash](const std::string& text) {
        hash.addData(QByteArray::fromStdString(text));
        hash.addData(QByteArrayLiteral("\n"));
    };
    forEachStimulus(protocol, [&](const std::string& id, const std::string& file) {
        add(id);
        if (const OwnStimulus* one = findIn(own, id))
            add(one->json);
        else if (const pattern::Pattern* builtIn = pattern::findBuiltIn(id);
                 builtIn != nullptr && file.empty())
            add(pattern::patternToJson(*builtIn).value_or(std::string()));
    });
    return hash.result().toHex().toStdString();
}

std::vector<std::string> missingStimuli(const Protocol& protocol) {
    std::vector<std::string> missing;
    forEachStimulus(protocol, [&](const std::string& id, const std::string& file) {
        if (file.empty() && pattern::findBuiltIn(id) == nullptr)
            missing.push_back(id);
    });
    return missing;
}

core::Expected<StimulusSet> StimulusSet::of(const Protocol& protocol, std::vector<OwnStimulus> own,
                                            const std::string& place) {
    StimulusSet set;
    for (const OwnStimulus& one : own) {
        TELETA_TRY(pattern::Pattern read, pattern::patternFromJson(one.json, place + ": " + one.file));
        set.m_patterns[one.id] = std::make_shared<const pattern::Pattern>(std::move(read));
    }
    forEachStimulus(protocol, [&](const std::string& id, const std::string& file) {
        if (set.m_patterns.contains(id))
            return;
        const pattern::Pattern* builtIn = file.empty() ? pattern::findBuiltIn(id) : nullptr;
        if (builtIn == nullptr)
            set.m_missing.push_back(id);
        else
            set.m_patterns[id] = std::shared_ptr<const pattern::Pattern>(std::shared_ptr<void>(), builtIn);
    });
    set.m_sha256 = stimulusSetSha256(protocol, own);
    set.m_own = std::move(own);
    return set;
}

const pattern::Pattern* StimulusSet::find(const std::string& id) const {
    const auto found = m_patterns.find(id);
    return found == m_patterns.end() ? nullptr : found->second.get();
}

const OwnStimulus* StimulusSet::findOwn(const std::string& id) const {
    return findIn(m_own, id);
}

} // namespace teleta::study
