// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/model/accuracy_model.h"

#include <algorithm>
#include <map>

namespace teleta::study {

tl::expected<AccuracyModel, ModelRefusal> accuracyModel(const TaskResults& task) {
    AccuracyModel model;
    std::vector<std::string> conditions;
    bool isSeparable = false;
    for (const GroupSummary& group : task.groups) {
        conditions.push_back(group.condition);
        const std::int64_t correct = group.matrix.correct();
        isSeparable = isSeparable || correct == 0 || correct == group.matrix.total();
        model.trials += group.matrix.total();
    }
    if (model.trials == 0)
        return tl::unexpected(ModelRefusal::noData);
    std::map<std::string, std::size_t> people;
    BinomialModel whole;
    BinomialModel without;
    for (const ParticipantSummary& person : task.participants) {
        const std::size_t participant = people.try_emplace(person.participant, people.size()).first->second;
        BinomialRow row{participant, {1.0}, person.matrix.correct(), person.matrix.total()};
        without.rows.push_back(row);
        for (std::size_t i = 1; i < conditions.size(); ++i)
            row.x.push_back(conditions[i] == person.condition ? 1.0 : 0.0);
        whole.rows.push_back(std::move(row));
    }
    if (people.size() < kFewestModelParticipants)
        return tl::unexpected(ModelRefusal::tooFewParticipants);
    if (isSeparable)
        return tl::unexpected(ModelRefusal::separable);
    tl::expected<BinomialFit, ModelRefusal> fit = fitBinomial(whole);
    if (!fit)
        return tl::unexpected(fit.error());
    model.fit = std::move(*fit);
    model.reference = conditions.front();
    model.terms.assign(conditions.begin() + 1, conditions.end());
    if (!model.terms.empty()) {
        const tl::expected<BinomialFit, ModelRefusal> part = fitBinomial(without);
        if (!part)
            return tl::unexpected(part.error());
        model.condition = ratioTest(model.fit, *part, model.terms.size());
    }
    return model;
}

} // namespace teleta::study
