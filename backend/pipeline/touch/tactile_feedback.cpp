// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/tactile_feedback.h"

#include "backend/core/steady_time.h"

#include <utility>

namespace teleta::pipeline {

namespace {

using playback::Program;

Program oneAfterTheOther(const Program& first, const Program& second) {
    const double begin_s = first.duration_s + TactileFeedback::kPause_s;
    return {[first, second, begin_s](double t_s) {
                return t_s < begin_s ? first.evaluate(t_s) : second.evaluate(t_s - begin_s);
            },
            begin_s + second.duration_s};
}

} // namespace

TactileFeedback::TactileFeedback(Play play)
    : m_play(std::move(play)) {
    m_settings.set(std::make_shared<const Settings>());
}

void TactileFeedback::setMap(const pattern::PatternMap& map, const Library& library) {
    const auto entryOf = [&library](const std::string& id) {
        return id.empty() ? Entry{} : Entry{id, library(id)};
    };
    Settings settings = *m_settings.get();
    for (std::size_t i = 0; i < map.stiffness.size(); ++i)
        settings.stiffness[i] = entryOf(map.stiffness[i]);
    settings.unknownStiffness = entryOf(map.unknownStiffness);
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
    if (!contour.recognition) {
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
    if (!record.stiffness->materialKnown())
        return &settings.unknownStiffness;
    return &settings.stiffness[static_cast<std::size_t>(stiffness::level(record.stiffness->material)) - 1];
}

void TactileFeedback::onTouch(const TouchRecord& record) {
    const std::shared_ptr<const Settings> settings = m_settings.get();
    const Entry* entry = ofStiffness(*settings, record);
    if (entry == nullptr)
        return;
    const std::int64_t evaluated_ns = core::steadyNow_ns();
    const bool taken = entry->program.evaluate && m_play(entry->program);
    FeedbackSent sent = messageOf(record, *entry, taken);
    sent.sent_ns = evaluated_ns;
    if (record.stiffness->materialKnown())
        sent.material = record.stiffness->material;
    else
        sent.unknownStiffness = true;
    m_sent.push(std::move(sent));
}

void TactileFeedback::onContour(const TouchRecord& record, const ExploredContour& contour) {
    const std::optional<contour::Shape> shape = newShape(contour);
    const std::shared_ptr<const Settings> settings = m_settings.get();
    if (!shape || (settings->mode != FeedbackMode::shape && settings->mode != FeedbackMode::both))
        return;
    const Entry& entry = settings->shape[static_cast<std::size_t>(*shape)];
    const Entry* before = ofStiffness(*settings, record);
    const std::int64_t evaluated_ns = core::steadyNow_ns();
    // The pattern of the stiffness has begun a moment ago: it begins again, with the shape behind it.
    const bool taken = entry.program.evaluate && m_play(before != nullptr && before->program.evaluate
                                                            ? oneAfterTheOther(before->program, entry.program)
                                                            : entry.program);
    FeedbackSent sent = messageOf(record, entry, taken);
    sent.sent_ns = evaluated_ns;
    sent.shape = shape;
    m_sent.push(std::move(sent));
}

FeedbackSent TactileFeedback::messageOf(const TouchRecord& record, const Entry& entry, bool taken) {
    FeedbackSent sent;
    sent.touch = record.number;
    sent.patternId = entry.id;
    sent.missing = !entry.id.empty() && !entry.program.evaluate;
    sent.refused = !entry.id.empty() && !sent.missing && !taken;
    sent.felt_ns = record.ready_ns;
    sent.arrived_ns = record.arrived_ns;
    return sent;
}

} // namespace teleta::pipeline
