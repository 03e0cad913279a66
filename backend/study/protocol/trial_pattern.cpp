// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/trial_pattern.h"

#include "backend/core/failure.h"
#include "backend/study/protocol/level_sequence.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

namespace teleta::study {

namespace {

using pattern::ObjectForm;
using pattern::Pattern;
using pattern::PatternObject;

struct TrialText {
    Q_DECLARE_TR_FUNCTIONS(StimulusText)
};

/// Times of a file are rounded.
constexpr double kShortest_s = 1e-9;

template <typename... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

/// Sets a time or balance of an object; false: the object has none.
bool setForm(ObjectForm& form, Vary vary, double level) {
    return std::visit(Overloaded{[&](pattern::Sweep& sweep) {
                                     if (vary == Vary::onset)
                                         sweep.onset_s = level;
                                     else if (vary == Vary::burst)
                                         sweep.burst_s = level;
                                     return vary == Vary::onset || vary == Vary::burst;
                                 },
                                 [&](pattern::Ring& ring) {
                                     if (vary == Vary::burst)
                                         ring.burst_s = level;
                                     else if (vary == Vary::duration)
                                         ring.duration_s = level;
                                     return vary == Vary::burst || vary == Vary::duration;
                                 },
                                 [&](pattern::Phantom& phantom) {
                                     if (vary == Vary::balance)
                                         phantom.balanceFrom = phantom.balanceTo = level;
                                     else if (vary == Vary::duration)
                                         phantom.duration_s = level;
                                     return vary == Vary::balance || vary == Vary::duration;
                                 },
                                 [&](pattern::Ramp& ramp) {
                                     if (vary == Vary::duration)
                                         ramp.duration_s = level;
                                     return vary == Vary::duration;
                                 },
                                 [&](pattern::PulseTrain& train) {
                                     if (vary == Vary::burst)
                                         train.width_s = level;
                                     else if (vary == Vary::duration)
                                         train.duration_s = level;
                                     return vary == Vary::burst || vary == Vary::duration;
                                 },
                                 [](pattern::Stroke&) { return false; }},
                      form);
}

void scaleForm(ObjectForm& form, double factor) {
    std::visit(Overloaded{[&](pattern::Ramp& ramp) {
                              ramp.from *= factor;
                              ramp.to *= factor;
                          },
                          [&](auto& other) { other.intensity *= factor; }},
               form);
}

void shiftForm(ObjectForm& form, double by_s) {
    std::visit([by_s](auto& object) { object.start_s += by_s; }, form);
}

void addOnce(std::vector<std::size_t>& tactors, std::size_t tactor) {
    if (std::ranges::find(tactors, tactor) == tactors.end())
        tactors.push_back(tactor);
}

/// The tactors that a pattern uses, in the order in which it names them.
std::vector<std::size_t> usedTactors(const Pattern& pattern) {
    std::vector<std::size_t> used;
    for (const PatternObject& object : pattern.objects) {
        for (const int tactor : pattern::listedTactors(object.form))
            addOnce(used, core::wrappedTactor(tactor));
    }
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
        if (!pattern.tracks[tactor].empty())
            addOnce(used, tactor);
    }
    return used;
}

/// Where a tactor goes; empty: it is left out.
using Moved = std::array<std::optional<std::size_t>, core::kTactors>;

std::vector<int> moved(const std::vector<int>& tactors, const Moved& to) {
    std::vector<int> kept;
    for (const int tactor : tactors) {
        if (const auto place = to[core::wrappedTactor(tactor)])
            kept.push_back(static_cast<int>(*place));
    }
    return kept;
}

/// Moves the tactors of an object; false: an object of this kind cannot be moved so.
bool moveForm(ObjectForm& form, const Moved& to) {
    return std::visit(Overloaded{[&](pattern::Phantom& phantom) {
                                     const auto first = to[core::wrappedTactor(phantom.first)];
                                     const auto second = to[core::wrappedTactor(phantom.second)];
                                     if (first && second) {
                                         phantom.first = static_cast<int>(*first);
                                         phantom.second = static_cast<int>(*second);
                                     }
                                     return first && second;
                                 },
                                 [](pattern::Ring&) { return false; }, [](pattern::Stroke&) { return false; },
                                 [&](auto& listed) {
                                     listed.tactors = moved(listed.tactors, to);
                                     return true;
                                 }},
                      form);
}

core::Unexpected unfit(const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::refused, message, expected);
}

/// Adds a pattern with its tactors moved to another one.
core::Expected<void> addMoved(const Pattern& pattern, const Moved& to, Pattern& sum) {
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
        if (to[tactor] && !pattern.tracks[tactor].empty())
            sum.tracks[*to[tactor]] = pattern.tracks[tactor];
    }
    for (PatternObject object : pattern.objects) {
        if (!moveForm(object.form, to))
            return unfit(TrialText::tr("\"%1\" cannot be moved to other tactors").arg(object.name.c_str()),
                         TrialText::tr("a stimulus without rings and strokes, or a track without tactors"));
        sum.objects.push_back(std::move(object));
    }
    return {};
}

core::Expected<Pattern> onTactors(const Pattern& pattern, const std::vector<std::size_t>& tactors) {
    if (tactors.empty())
        return pattern;
    const std::vector<std::size_t> used = usedTactors(pattern);
    Pattern sum = pattern;
    sum.tracks = {};
    sum.objects.clear();
    if (used.size() == 1) {
        for (const std::size_t tactor : tactors) {
            Moved to;
            to[used.front()] = tactor;
            TELETA_CHECK(addMoved(pattern, to, sum));
        }
        return sum;
    }
    Moved to;
    if (used.size() == tactors.size()) {
        for (std::size_t i = 0; i < used.size(); ++i)
            to[used[i]] = tactors[i];
    } else {
        for (const std::size_t tactor : tactors) {
            if (std::ranges::find(used, tactor) == used.end())
                return unfit(TrialText::tr("the stimulus does not use tactor %1").arg(tactor + 1),
                             TrialText::tr("a stimulus of one tactor, or of as many as the track names"));
            to[tactor] = tactor;
        }
    }
    TELETA_CHECK(addMoved(pattern, to, sum));
    return sum;
}

core::Expected<Pattern> atLevel(const Pattern& stimulus, Vary vary, double level) {
    Pattern pattern = stimulus;
    if (vary == Vary::intensity) {
        for (pattern::Track& track : pattern.tracks) {
            for (pattern::Breakpoint& point : track)
                point.intensity *= level;
        }
        for (PatternObject& object : pattern.objects)
            scaleForm(object.form, level);
        return pattern;
    }
    std::size_t set = 0;
    for (PatternObject& object : pattern.objects)
        set += setForm(object.form, vary, level) ? 1 : 0;
    if (set != 1)
        return unfit(TrialText::tr("%n object(s) of the stimulus have %1", nullptr, static_cast<int>(set))
                         .arg(QString::fromLatin1(toString(vary))),
                     TrialText::tr("exactly one"));
    return pattern;
}

double endOf_s(const Pattern& pattern) {
    double end_s = 0.0;
    for (const pattern::Track& track : pattern.tracks) {
        if (!track.empty())
            end_s = std::max(end_s, track.back().time_s);
    }
    for (const PatternObject& object : pattern.objects)
        end_s = std::max(end_s, pattern::spanOf(object.form).end_s);
    return end_s;
}

const LevelTrack* trackOf(const LevelTask& task, const std::string& id) {
    const auto found = std::ranges::find(task.tracks, id, &LevelTrack::id);
    return found == task.tracks.end() ? nullptr : &*found;
}

} // namespace

core::Expected<Pattern> stimulusAt(const Pattern& stimulus, Vary vary, double level,
                                   const std::vector<std::size_t>& tactors) {
    TELETA_TRY(const Pattern set, atLevel(stimulus, vary, level));
    return onTactors(set, tactors);
}

std::vector<TrialInterval> intervalsOf(const StudyTask& task, const std::string& condition,
                                       const PlannedTrial& trial) {
    const LevelTrack* track = trackOf(task.levels, trial.track);
    const std::vector<std::size_t> tactors = track != nullptr ? track->tactors : std::vector<std::size_t>();
    const TrialInterval level{trial.level.value_or(0.0), tactors};
    const TrialInterval reference{task.referenceOf(condition),
                                  track != nullptr && !track->reference.empty() ? track->reference : tactors};
    const Target target = trial.target.value_or(0);
    switch (task.design) {
    case Design::identification:
        return {};
    case Design::yesNo:
        return {target == 1 ? level : reference};
    case Design::sameDifferent:
        return {target % 2 == 0 ? reference : level, target == 0 || target == 3 ? reference : level};
    case Design::interval:
    case Design::compare:
        break;
    }
    std::vector<TrialInterval> intervals(intervalsOf(task.design, task.levels), reference);
    intervals.at(target) = level;
    return intervals;
}

double trialLength_s(const StudyTask& task, double interval_s) {
    const auto intervals = static_cast<double>(intervalsOf(task.design, task.levels));
    return intervals * interval_s + (intervals - 1.0) * task.levels.gap_s;
}

core::Expected<Pattern> trialPattern(const StudyTask& task, const std::string& condition,
                                     const Pattern& stimulus, double interval_s, const PlannedTrial& trial) {
    Pattern whole;
    whole.id = stimulus.id;
    whole.name = stimulus.name;
    whole.arm = stimulus.arm;
    whole.duration_s = trialLength_s(task, interval_s);
    double begin_s = 0.0;
    for (const TrialInterval& interval : intervalsOf(task, condition, trial)) {
        TELETA_TRY(Pattern part, stimulusAt(stimulus, task.levels.vary, interval.level, interval.tactors));
        if (endOf_s(part) > interval_s + kShortest_s)
            return unfit(
                TrialText::tr("the stimulus takes %1 s at level %2").arg(endOf_s(part)).arg(interval.level),
                TrialText::tr("at most stimulus_s, %1 s").arg(interval_s));
        for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
            for (pattern::Breakpoint& point : part.tracks[tactor]) {
                point.time_s += begin_s;
                whole.tracks[tactor].push_back(point);
            }
            // Off until the next interval begins.
            if (!part.tracks[tactor].empty())
                whole.tracks[tactor].push_back(
                    {part.tracks[tactor].back().time_s, 0.0, pattern::Easing::hold});
        }
        for (PatternObject& object : part.objects) {
            shiftForm(object.form, begin_s);
            whole.objects.push_back(std::move(object));
        }
        begin_s += interval_s + task.levels.gap_s;
    }
    return whole;
}

core::Expected<void> checkStimulus(const Protocol& protocol, const StudyTask& task, const Pattern& stimulus) {
    std::vector<double> levels{task.levels.range.lowest, task.levels.range.highest};
    for (const std::string& condition : task.conditions)
        levels.push_back(task.referenceOf(condition));
    for (const LevelTrack& track : task.levels.tracks) {
        for (const double level : levels) {
            for (const std::vector<std::size_t>* tactors : {&track.tactors, &track.reference}) {
                const auto part = stimulusAt(stimulus, task.levels.vary, level, *tactors);
                TELETA_CHECK(part);
                if (endOf_s(*part) > protocol.stimulus_s + kShortest_s)
                    return unfit(
                        TrialText::tr("the stimulus takes %1 s at level %2").arg(endOf_s(*part)).arg(level),
                        TrialText::tr("at most stimulus_s, %1 s").arg(protocol.stimulus_s));
            }
        }
    }
    return {};
}

} // namespace teleta::study
