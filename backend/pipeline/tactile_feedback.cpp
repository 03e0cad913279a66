// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/tactile_feedback.h"

#include "backend/core/steady_time.h"

#include <utility>

namespace teleta::pipeline {

namespace {

using Compiled = std::shared_ptr<const pattern::CompiledPattern>;

playback::Program programOf(Compiled pattern) {
    const double duration_s = pattern->duration_s();
    return {.evaluate = [pattern = std::move(pattern)](double t_s) { return pattern->evaluate(t_s); },
            .duration_s = duration_s};
}

playback::Program oneAfterTheOther(Compiled first, Compiled second) {
    const double begin_s = first->duration_s() + TactileFeedback::kPause_s;
    const double duration_s = begin_s + second->duration_s();
    return {.evaluate =
                [first = std::move(first), second = std::move(second), begin_s](double t_s) {
                    return t_s < begin_s ? first->evaluate(t_s) : second->evaluate(t_s - begin_s);
                },
            .duration_s = duration_s};
}

} // namespace

TactileFeedback::TactileFeedback(Play play)
    : m_play(std::move(play)) {
    m_settings.set(std::make_shared<const Settings>());
}

void TactileFeedback::setMap(const pattern::PatternMap& map, const Library& library) {
    const auto entryOf = [&library](const std::string& id) {
        const pattern::Pattern* pattern = id.empty() ? nullptr : library(id);
        return pattern == nullptr ? Entry{}
                                  : Entry{id, std::make_shared<const pattern::CompiledPattern>(*pattern)};
    };
    Settings settings = *m_settings.get();
    for (std::size_t i = 0; i < map.stiffness.size(); ++i)
        settings.stiffness[i] = entryOf(map.stiffness[i]);
    for (std::size_t i = 0; i < map.shape.size(); ++i)
        settings.shape[i] = entryOf(map.shape[i]);
    m_settings.set(std::make_shared<const Settings>(std::move(settings)));
}

void TactileFeedback::setMode(FeedbackMode mode) {
    Settings settings = *m_settings.get();
    settings.mode = mode;
    m_settings.set(std::make_shared<const Settings>(std::move(settings)));
}

std::optional<contour::Shape> TactileFeedback::newShape(const ExploredContour& contour) {
    if (contour.points_m.size() < kLeastPoints || !contour.recognition) {
        m_lastShape.reset();
        return std::nullopt;
    }
    if (contour.recognition->confidence < kLeastConfidence || contour.recognition->shape == m_lastShape)
        return std::nullopt;
    m_lastShape = contour.recognition->shape;
    return m_lastShape;
}

const TactileFeedback::Entry* TactileFeedback::ofStiffness(const Settings& settings,
                                                           const TouchRecord& record) {
    const bool tells = settings.mode == FeedbackMode::stiffness || settings.mode == FeedbackMode::both;
    if (!tells || !record.stiffness)
        return nullptr;
    return &settings.stiffness[static_cast<std::size_t>(stiffness::level(record.stiffness->material)) - 1];
}

void TactileFeedback::onTouch(const TouchRecord& record) {
    const std::shared_ptr<const Settings> settings = m_settings.get();
    const Entry* entry = ofStiffness(*settings, record);
    if (entry == nullptr)
        return;
    if (entry->pattern)
        m_play(programOf(entry->pattern));
    FeedbackSent sent = messageOf(record, *entry);
    sent.material = record.stiffness->material;
    m_sent.push(std::move(sent));
}

void TactileFeedback::onContour(const TouchRecord& record, const ExploredContour& contour) {
    const std::optional<contour::Shape> shape = newShape(contour);
    const std::shared_ptr<const Settings> settings = m_settings.get();
    if (!shape || (settings->mode != FeedbackMode::shape && settings->mode != FeedbackMode::both))
        return;
    const Entry& entry = settings->shape[static_cast<std::size_t>(*shape)];
    const Entry* before = ofStiffness(*settings, record);
    if (entry.pattern) {
        // The pattern of the stiffness has begun a moment ago: it begins again, with the shape behind it.
        m_play(before != nullptr && before->pattern ? oneAfterTheOther(before->pattern, entry.pattern)
                                                    : programOf(entry.pattern));
    }
    FeedbackSent sent = messageOf(record, entry);
    sent.shape = shape;
    m_sent.push(std::move(sent));
}

FeedbackSent TactileFeedback::messageOf(const TouchRecord& record, const Entry& entry) {
    FeedbackSent sent;
    sent.touch = record.number;
    sent.patternId = entry.id;
    sent.felt_ns = record.ready_ns;
    sent.sent_ns = core::steadyNow_ns();
    return sent;
}

} // namespace teleta::pipeline
